using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client;

/// <content>How objects come and go.</content>
public sealed partial class RemoteWorld
{
    /// <summary>An object is described: it is made, or what is news of it is taken over.</summary>
    /// <remarks>Retail: SmartBox::HandleCreateObject @0x00454C80, HandleUpdateObject @0x00455580; specification 09, 5.8.</remarks>
    private void Create(ObjectDescription description, bool isForced, in WireMessage message)
    {
        uint guid = description.Guid;
        PhysicsDescription physics = description.Physics;
        if (guid == player)
        {
            playerInstance = physics.Stamps.Instance;
            if (engine.Find(guid) is not null) Hear(guid);
            return;
        }

        if (guid == 0 || physics.Parent is { Guid: 0 })
        {
            Drops.Add(RemoteDrop.BadValue);
            return;
        }

        if (physics.Parent is { } link && FindHolder(link.Guid) is null && link.Guid != guid)
        {
            Wait(link.Guid, message);
            return;
        }

        if (objects.TryGetValue(guid, out RemoteBody? known))
        {
            InstanceAge age = known.Stamps.AgeOf(physics.Stamps.Instance);
            if (!isForced && age != InstanceAge.Ahead)
            {
                if (age == InstanceAge.Current) Refresh(known, description);
                else Drops.Add(RemoteDrop.EarlierLife);
                return;
            }

            Delete(known);
        }
        else if (engine.Find(guid) is not null)
        {
            Drops.Add(RemoteDrop.NotOurs);
            return;
        }

        Make(description);
    }

    /// <remarks>
    /// Retail: ACCObjectMaint::CreateObject @0x00558870. There an object whose motions are in no file still stands where it was put, known
    /// to nobody for ever; here it is left out.
    /// </remarks>
    private void Make(ObjectDescription description)
    {
        PhysicsDescription physics = description.Physics;
        if (objects.Count >= options.MostObjects)
        {
            Drops.Add(RemoteDrop.NoRoom);
            return;
        }

        MotionTableAsset? table = null;
        if (physics.Setup is not { } shape || !assets.TryGetSetup(shape, out SetupAsset? setup) ||
            (physics.MotionTable is { } motions and not 0 && !assets.TryGetMotions(motions, setup, out table)))
        {
            Drops.Add(RemoteDrop.NoAssets);
            return;
        }

        HoldingLink? holder = Hear(description.Guid);
        WeenieTraits traits = WeenieForms.TraitsOf(description.Weenie);
        OtherWeenie weenie = new((traits & WeenieTraits.Creature) != 0);
        PhysicsBody body = engine.CreateBody(
            description.Guid, setup, PhysicsState.Default, traits, motions: table is null ? null : new BodyMotions(table, weenie),
            listed: false);
        RemoteBody item = new(engine, body, description, weenie);
        Describe(item, physics);
        Attach(item, physics, holder);
        engine.Enlist(body);
        objects.Add(body.Id, item);
        EnterWorld(item, physics);
        options.Observer?.OnCreated(item);
    }

    /// <summary>An object is no longer waited for: its messages will be heard next.</summary>
    /// <returns>Who is to hold it, as far as it was told.</returns>
    private HoldingLink? Hear(uint guid)
    {
        if (!placeholders.TryTake(guid, out Placeholder? placeholder)) return null;
        timers.Stop(guid);
        replays.Push(new Replay(placeholder.Messages));
        return placeholder.Holder;
    }

    /// <summary>
    /// Motions first, then the state word, then what depends on it. The object is not listed yet: whom it follows cannot tell it anything.
    /// </summary>
    /// <remarks>Retail: CPhysicsObj::set_description @0x00514F40; specification 02, 4.18.</remarks>
    private void Describe(RemoteBody item, PhysicsDescription physics)
    {
        PhysicsBody body = item.Body;
        if (physics.Movement is { } movement)
        {
            body.LastMoveWasAutonomous = physics.Autonomous != 0;
            if (item.Movement is { } manager && !orders.TryObey(manager, movement, physics.Autonomous != 0))
                Drops.Add(RemoteDrop.BadValue);
        }
        else
        {
            item.PutDown(physics.Placement);
        }

        body.SetState((PhysicsState)physics.State);
        if (physics.Scale is { } scale)
        {
            if (WireForms.IsScale(scale)) body.SetScale(scale);
            else Drops.Add(RemoteDrop.BadValue);
        }

        if (physics.Friction is { } friction)
        {
            if (float.IsFinite(friction)) body.SetFriction(friction);
            else Drops.Add(RemoteDrop.BadValue);
        }

        if (physics.Elasticity is { } elasticity)
        {
            if (float.IsFinite(elasticity)) body.SetElasticity(elasticity);
            else Drops.Add(RemoteDrop.BadValue);
        }

        Vector3 velocity = physics.Velocity ?? default, omega = physics.Omega ?? default;
        if (WireForms.IsVector(velocity) && WireForms.IsVector(omega))
        {
            body.SetVelocity(velocity);
            body.SetOmega(omega);
        }
        else
        {
            Drops.Add(RemoteDrop.BadValue);
        }

        item.TakeStamps(physics.Stamps);
    }

    /// <summary>What it holds, known or not, and who holds it: as it is told, else as the holder told before.</summary>
    /// <remarks>Retail: CObjectMaint::SetChildren @0x00509370.</remarks>
    private void Attach(RemoteBody item, PhysicsDescription physics, HoldingLink? before)
    {
        foreach (HoldingLink link in physics.Children ?? default)
        {
            if (objects.TryGetValue(link.Guid, out RemoteBody? held)) SetParent(held, item.Body, link.Location);
            else Promise(item, link);
        }

        if ((physics.Parent ?? before) is { } holding && FindHolder(holding.Guid) is { } holder)
            SetParent(item, holder, holding.Location);
    }

    private void SetParent(RemoteBody item, PhysicsBody holder, uint location)
    {
        if (item.Body.SetParent(holder, location)) Unwatch(item);
        else Drops.Add(RemoteDrop.NotHeld);
    }

    /// <summary>
    /// An unknown object will be held as soon as it is known. Until then it waits without end, if there is a place to hold it.
    /// </summary>
    private void Promise(RemoteBody holder, HoldingLink link)
    {
        if (link.Guid == player || link.Guid == 0 || link.Guid == holder.Id) return;
        if (placeholders.Get(link.Guid, now) is not { } placeholder)
        {
            Drops.Add(RemoteDrop.NoRoom);
        }
        else if (holder.Body.Setup!.TryGetHoldingLocation(link.Location, out _))
        {
            placeholder.Holder = new HoldingLink(holder.Id, link.Location);
            timers.Stop(link.Guid);
        }
        else
        {
            Drops.Add(RemoteDrop.NotHeld);
            timers.Start(link.Guid, now);
        }
    }

    /// <summary>
    /// Puts an object where it is told to be, unless somebody holds it. One that there is no room for stays known, in no cell.
    /// </summary>
    private void EnterWorld(RemoteBody item, PhysicsDescription physics)
    {
        if (item.Body.Parent is not null || physics.Position is not { Cell: not 0 } told) return;
        if (WireForms.TryRead(told, out Position place)) item.Body.EnterWorld(place);
        else Drops.Add(RemoteDrop.BadValue);
        WatchAnew(item);
    }

    /// <summary>A known object is described again: each part acts by its own stamp.</summary>
    /// <remarks>Specification 09, 5.8 and 08, 4.5, step 2.</remarks>
    private void Refresh(RemoteBody item, ObjectDescription description)
    {
        PhysicsDescription physics = description.Physics;
        ObjectStamps stamps = physics.Stamps;
        item.TryTakeModel(description.Model, stamps.ObjDesc);
        if (physics.Parent is { } link)
        {
            if (FindHolder(link.Guid) is { } holder &&
                item.TryBeHeld(holder, link.Location, physics.Placement, stamps.Position, out bool isHeld))
            {
                if (isHeld) Unwatch(item);
                else Drops.Add(RemoteDrop.NotHeld);
            }
        }
        else if (physics.Position is { Cell: not 0 } told)
        {
            if (!WireForms.TryRead(told, out Position place)) Drops.Add(RemoteDrop.BadValue);
            else item.TryTakePosition(place, contact: true, stamps.Position, stamps.Teleport, physics.Placement);
        }
        else if (item.TryLeave(stamps.Position))
        {
            Unwatch(item);
        }

        if (physics.Movement is { } movement)
        {
            item.TryObey(movement, stamps.Movement, stamps.ServerControlledMove, physics.Autonomous != 0, orders, out bool isReadable);
            if (!isReadable) Drops.Add(RemoteDrop.BadValue);
        }

        item.TryTakeState(physics.State, stamps.State);
        Vector3 velocity = physics.Velocity ?? default, omega = physics.Omega ?? default;
        if (WireForms.IsVector(velocity) && WireForms.IsVector(omega)) item.TryTakeVelocity(velocity, omega, stamps.Vector);
        else Drops.Add(RemoteDrop.BadValue);
        item.TakeWeenie(description.Weenie);
        RenewTimer(item);
    }

    /// <summary>The timer after a description: none in a pack or in a cell, 25 s elsewhere.</summary>
    private void RenewTimer(RemoteBody item)
    {
        item.WasOutOfSight = item.IsOutOfSight;
        uint cell = item.Body.Position.CellId;
        if (cell != 0 && item.Body.Cell is null) timers.Start(item.Id, now);
        else if (cell != 0) timers.Stop(item.Id);
    }

    /// <summary>Starts the timer of an object that went out of sight, and stops that of one that came back.</summary>
    private void Watch(RemoteBody item, double since)
    {
        bool isOut = item.IsOutOfSight;
        if (isOut == item.WasOutOfSight) return;
        item.WasOutOfSight = isOut;
        if (isOut) timers.Start(item.Id, since);
        else timers.Stop(item.Id);
    }

    /// <summary>An object left the world: it is not waited for.</summary>
    private void Unwatch(RemoteBody item)
    {
        item.WasOutOfSight = item.IsOutOfSight;
        timers.Stop(item.Id);
    }

    /// <summary>An object was put somewhere: out of sight, its timer starts again; else it has none.</summary>
    private void WatchAnew(RemoteBody item)
    {
        item.WasOutOfSight = item.IsOutOfSight;
        if (item.WasOutOfSight) timers.Start(item.Id, now);
        else timers.Stop(item.Id);
    }

    /// <summary>The time of an object is over.</summary>
    private void Destroy(uint guid)
    {
        if (objects.TryGetValue(guid, out RemoteBody? item)) Delete(item);
        else if (placeholders.TryTake(guid, out Placeholder? placeholder)) Drops.Add(RemoteDrop.NeverCame, placeholder.Messages.Count);
    }

    /// <summary>Forgets an object; what it holds is let go and stays known.</summary>
    /// <remarks>Retail: CObjectMaint::DeleteObject @0x00508460; specification 09, 5.6.</remarks>
    private void Delete(RemoteBody item)
    {
        options.Observer?.OnDeleting(item);
        objects.Remove(item.Id);
        timers.Stop(item.Id);
        engine.RemoveBody(item.Body);
        placeholders.LetGo(item.Id, guid => timers.Start(guid, now));
    }
}
