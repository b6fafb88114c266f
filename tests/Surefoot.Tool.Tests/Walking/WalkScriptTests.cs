using Surefoot.Client;
using Surefoot.Tool.Walking;

namespace Surefoot.Tool.Tests.Walking;

public class WalkScriptTests
{
    [Fact, Behaviour("tool.walk.script-grammar", "design.md, The tool")]
    public void Legs_name_keys_and_seconds()
    {
        IReadOnlyList<WalkLeg> legs = WalkScript.Parse("W 3; w+SPACE 0.6 ;Shift+S+Q 2;Wait 0.25;auto+A 0;");
        Assert.Equal(
            [
                new(MovementKeys.Forward, 3), new(MovementKeys.Forward | MovementKeys.Jump, 0.6),
                new(MovementKeys.Walk | MovementKeys.Back | MovementKeys.SidestepLeft, 2), new WalkLeg(MovementKeys.None, 0.25),
                new WalkLeg(MovementKeys.TurnLeft, 0, AutoRun: true),
            ],
            legs);
    }

    [Theory, Behaviour("tool.walk.script-mistakes-have-a-place", "design.md, decision 7")]
    [InlineData("", 0)]
    [InlineData(";;", 0)]
    [InlineData("X 1", 0)]
    [InlineData("W 1; W+Jmp 2", 7)]
    [InlineData("W", 1)]
    [InlineData("W x", 2)]
    [InlineData("W 1;  W -2", 8)]
    [InlineData("W NaN", 2)]
    [InlineData("W 1e9", 0)]
    public void A_mistake_is_reported_where_it_is(string script, int position) =>
        Assert.Equal(position, Assert.Throws<WalkScriptException>(() => WalkScript.Parse(script)).Position);
}
