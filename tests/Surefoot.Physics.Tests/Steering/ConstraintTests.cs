using System.Numerics;
using Surefoot.Physics.Steering;

namespace Surefoot.Physics.Tests.Steering;

/// <summary>The leash: the worked examples of specification 09, 6.5.</summary>
public class ConstraintTests
{
    private readonly FakeSteeredBody body = new(new FakeSteeredWorld(), 1, new Vector3(10, 10, 0));

    [Theory]
    [Behaviour("steering.leash.brakes-and-holds", "spec/09, 6.5; ConstraintManager::adjust_offset @0x00556180")]
    [InlineData(9.9f, 0.5f, true, 10f, 50f, 0.5f, 10.3999996f)]
    [InlineData(10f, 0.5f, true, 10f, 50f, 0.5f, 10.5f)]
    [InlineData(10.4f, 0.5f, true, 10f, 50f, 0.495000005f, 10.8949995f)]
    [InlineData(30f, 0.5f, true, 10f, 50f, 0.25f, 30.25f)]
    [InlineData(49.9f, 0.5f, true, 10f, 50f, 0.00124998088f, 49.9012527f)]
    [InlineData(50f, 0.5f, true, 10f, 50f, 0f, 50f)]
    [InlineData(50f, 0.5f, false, 10f, 50f, 0.5f, 50.5f)]
    [InlineData(30f, 0.5f, false, 10f, 50f, 0.5f, 30.5f)]
    [InlineData(5f, 0.3f, true, 5f, 20f, 0.300000012f, 5.30000019f)]
    [InlineData(12.5f, 0.3f, true, 5f, 20f, 0.150000006f, 12.6499996f)]
    [InlineData(19.5f, 0.3f, true, 5f, 20f, 0.0100000007f, 19.5100002f)]
    public void After_some_path_a_leash_brakes_and_then_it_holds(
        float soFar, float offset, bool contact, float start, float max, float braked, float path)
    {
        body.Warp(FakeSteeredBody.At(0, 0));
        body.ConstrainTo(FakeSteeredBody.At(0, soFar), start, max);
        body.Contact = contact;
        body.Root = new Vector3(0, offset, 0);
        body.Advance();
        Assert.Equal((braked, path), (body.Offset.Origin.Y, body.Leash.PathLength));
    }

    [Theory]
    [Behaviour("steering.leash.fully-constrained", "spec/09, 6.5; ConstraintManager::IsFullyConstrained @0x005560D0")]
    [InlineData(45f, 50f, false)]
    [InlineData(45.01f, 50f, true)]
    [InlineData(18f, 20f, false)]
    [InlineData(18.01f, 20f, true)]
    public void Nine_tenths_of_the_leash_are_all_of_it(float path, float max, bool full)
    {
        body.Warp(FakeSteeredBody.At(0, 0));
        Assert.False(body.IsFullyConstrained);
        body.ConstrainTo(FakeSteeredBody.At(0, path), 10, max);
        Assert.Equal(full, body.IsFullyConstrained);
        body.Unconstrain();
        Assert.Equal(full, body.IsFullyConstrained);
    }

    [Theory]
    [Behaviour("steering.leash.runs-out", "spec/09, 6.5")]
    [InlineData(
        0.353333354f, 10f, 50f,
        29, 10.2466698f, 30, 10.5978241f, 60, 19.8059883f, 90, 26.8622303f, 150, 36.4130211f, 300, 46.4097443f, 600, 49.7493095f)]
    [InlineData(
        0.104000002f, 5f, 20f,
        48, 4.99200201f, 49, 5.0960021f, 50, 5.19933653f, 100, 9.5479517f, 150, 12.6188898f, 300, 17.4005508f, 600, 19.6776009f)]
    public void Without_news_a_body_slows_and_never_gets_to_the_end_of_its_leash(float stride, float start, float max, params object[] rows)
    {
        body.ConstrainTo(body.Position, start, max);
        body.Root = new Vector3(0, stride, 0);
        int quantum = 0;
        for (int i = 0; i < rows.Length; i += 2)
        {
            for (; quantum < (int)rows[i]; quantum++) body.Advance();
            Assert.Equal((float)rows[i + 1], body.Leash.PathLength, 1e-6f);
        }
    }

    [Fact]
    [Behaviour("steering.leash.counts-path", "spec/09, 3.4")]
    public void A_leash_counts_path_and_not_distance()
    {
        body.ConstrainTo(body.Position, 10, 50);
        for (int i = 0; i < 10; i++)
        {
            body.Root = new Vector3(0, i % 2 == 0 ? 0.5f : -0.5f, 0);
            body.Advance();
        }

        Assert.Equal((10f, 5f), (body.Y, body.Leash.PathLength));
        body.Unconstrain();
        body.Advance();
        Assert.Equal(5f, body.Leash.PathLength);
    }

    [Theory]
    [Behaviour("steering.leash.lengths", "spec/09, 3.5; CPhysicsObj::GetStartConstraintDistance @0x0050EBC0")]
    [InlineData(0xA9B40019u, 10f, 50f)]
    [InlineData(0xA9B40100u, 5f, 20f)]
    [InlineData(0u, 10f, 50f)]
    public void A_leash_is_shorter_indoors(uint cell, float start, float max) =>
        Assert.Equal((start, max), (CorrectionDistances.LeashStart(cell), CorrectionDistances.LeashMax(cell)));
}
