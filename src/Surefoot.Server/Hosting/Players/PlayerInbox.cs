using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>What the messages are for of a client whose player is in the world.</summary>
internal sealed class PlayerInbox(WorldStage stage, PlayerItem player)
{
    private const int LongestSaying = 500;
    private const uint Speech = 2;

    /// <summary>Takes a message; what has no meaning here is dropped.</summary>
    public void Take(in WireMessage message)
    {
        switch (message.Id.Opcode)
        {
            case Opcode.GameAction:
                TakeAction(message);
                break;
            case Opcode.CharacterLogOff:
                player.BeginLeaving();
                break;
            case Opcode.ForceObjDesc when message.TryRead(out ForceObjDesc wish):
                if (stage.Find(wish.Guid) is { } item && player.Awareness.Knows(item))
                    player.Client.Send(new ObjDescEvent(item.Id, new ModelData(), item.Instance, 0));
                break;
            case Opcode.DddInterrogationResponse:
                player.Client.Send(new DddEnd());
                break;
        }
    }

    private void TakeAction(in WireMessage message)
    {
        switch (message.Id.Action)
        {
            case GameActionType.MoveToState when message.TryRead(out MoveToState move):
                player.Claims.Take(move);
                break;
            case GameActionType.AutonomousPosition when message.TryRead(out AutonomousPosition position):
                player.Claims.Take(position);
                break;
            case GameActionType.Jump when message.TryRead(out Jump jump):
                player.Claims.Take(jump);
                break;
            case GameActionType.LoginComplete:
                player.Appear();
                break;
            case GameActionType.Use when message.TryRead(out Use use):
                player.Use.Begin(use.Guid);
                break;
            case GameActionType.Talk when message.TryRead(out Talk talk) && talk.Text.Length is > 0 and <= LongestSaying:
                if (talk.Text[0] == '@') ChatCommands.Take(stage, player, talk.Text);
                else player.Audience.Tell(new HearSpeech(talk.Text, player.Name, player.Id, Speech));
                break;
            case GameActionType.RequestPing:
                player.Client.Send(new PingResponse());
                break;
        }
    }
}
