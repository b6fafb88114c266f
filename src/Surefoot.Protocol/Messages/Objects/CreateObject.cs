namespace Surefoot.Protocol.Messages;

/// <summary>All that a server says of an object (specification 08, 6.5).</summary>
/// <param name="Guid">The object.</param>
/// <param name="Model">What it looks like.</param>
/// <param name="Physics">How it is simulated.</param>
/// <param name="Weenie">What it is.</param>
public sealed record ObjectDescription(uint Guid, ModelData Model, PhysicsDescription Physics, WeenieDescription Weenie)
{
    internal static ObjectDescription Read(ref WireReader reader) => new(
        reader.ReadUInt32(), ModelData.Read(ref reader), PhysicsDescription.Read(ref reader), WeenieDescription.Read(ref reader));

    internal void Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        Model.Write(ref writer);
        Physics.Write(ref writer);
        Weenie.Write(ref writer);
    }
}

/// <summary>An object appears, or is told anew (specification 08, 6.5).</summary>
/// <param name="Object">All of it.</param>
/// <remarks>Retail: SmartBox::HandleCreateObject @0x00454C80.</remarks>
public readonly record struct CreateObject(ObjectDescription Object) : IObjectMessage<CreateObject>
{
    static Opcode IObjectMessage<CreateObject>.Opcode => Opcode.CreateObject;

    static CreateObject IMessage<CreateObject>.Read(ref WireReader reader) => new(ObjectDescription.Read(ref reader));

    void IMessage<CreateObject>.Write(ref WireWriter writer) => Object.Write(ref writer);
}

/// <summary>As <see cref="CreateObject"/>, but the object is made anew in any case (specification 08, 6.1).</summary>
/// <param name="Object">All of it.</param>
public readonly record struct UpdateObject(ObjectDescription Object) : IObjectMessage<UpdateObject>
{
    static Opcode IObjectMessage<UpdateObject>.Opcode => Opcode.UpdateObject;

    static UpdateObject IMessage<UpdateObject>.Read(ref WireReader reader) => new(ObjectDescription.Read(ref reader));

    void IMessage<UpdateObject>.Write(ref WireWriter writer) => Object.Write(ref writer);
}
