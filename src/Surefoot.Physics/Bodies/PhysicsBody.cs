using Surefoot.Physics.Assets;

namespace Surefoot.Physics.Bodies;

/// <summary>A body that moves.</summary>
public sealed class PhysicsBody(uint id, SetupAsset? setup, PhysicsState state) : WorldObject(id, setup, state);
