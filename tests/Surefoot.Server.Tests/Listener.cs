using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Server.Tests;

/// <summary>A client that keeps what it hears.</summary>
internal sealed class Listener : IMessageReceiver
{
    internal List<MessageId> Heard { get; } = [];

    internal List<UpdateMotion> Motions { get; } = [];

    internal List<PrivateUpdateSkill> Skills { get; } = [];

    internal PlayerDescription? Description { get; private set; }

    public void OnMessage(in WireMessage message)
    {
        Heard.Add(message.Id);
        if (message.TryRead(out UpdateMotion motion)) Motions.Add(motion);
        if (message.TryRead(out PrivateUpdateSkill skill)) Skills.Add(skill);
        if (message.TryRead(out PlayerDescription description)) Description = description;
    }
}
