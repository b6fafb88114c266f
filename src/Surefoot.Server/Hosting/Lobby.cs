using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>Where clients select a character: the account's characters are shown, new ones are made, one enters the world.</summary>
/// <remarks>Specification 08, 3.4, 8.5 and 8.6.</remarks>
internal sealed class Lobby(WorldServer server, CharacterBook book)
{
    private const uint UnknownCharacter = 0x0B, StillInWorld = 0x0D, NotYours = 0x0F, CannotBePlaced = 0x14;
    private const double PingInterval = 100;

    /// <summary>A client has come in.</summary>
    public void Welcome(ClientConnection client)
    {
        client.Send(new DddInterrogation(1, 1, 1, [0, 1]));
        ShowCharacters(client);
        server.Say($"account {client.Account} came in from {client.Address}");
    }

    /// <summary>A client is shown its characters: after its login, and when its player has left the world.</summary>
    public void ShowCharacters(ClientConnection client)
    {
        client.IsSelecting = true;
        client.NextPing = server.Now + PingInterval;
        client.Send(new CharacterList(
            0, [.. book.Of(client.Account).Select(one => new CharacterEntry(one.Guid, one.Name, 0))], [], CharacterBook.MostPerAccount,
            client.Account, 0, 1));
        client.Send(new ServerName(server.Stage.Players.Count, server.Options.Slots, server.Options.WorldName));
    }

    /// <summary>While it selects it hears a sign of life now and then (specification 08, 8.4).</summary>
    public void Update(ClientConnection client)
    {
        if (!client.IsSelecting || client.Player is not null || server.Now < client.NextPing) return;
        client.NextPing = server.Now + PingInterval;
        client.Send(new PingResponse());
    }

    /// <summary>Takes a message of a client that selects.</summary>
    public void Take(ClientConnection client, in WireMessage message)
    {
        switch (message.Id.Opcode)
        {
            case Opcode.DddInterrogationResponse:
                client.Send(new DddEnd());
                break;
            case Opcode.CharacterCreate when message.TryRead(out CharacterCreate wish):
                Create(client, wish);
                break;
            case Opcode.CharacterEnterWorldRequest:
                client.Send(new EnterWorldServerReady());
                break;
            case Opcode.CharacterEnterWorld when message.TryRead(out CharacterEnterWorld enter):
                Enter(client, enter);
                break;
        }
    }

    private void Create(ClientConnection client, CharacterCreate wish)
    {
        if (wish.Account != client.Account) return;
        if (wish.Skills.Count != CharacterCreate.SkillCount)
        {
            client.Link.Refuse(new AccountBoot(" the new character has another number of skills"), server.Now);
            return;
        }

        client.Send(book.Create(client.Account, wish));
    }

    private void Enter(ClientConnection client, in CharacterEnterWorld enter)
    {
        Character? character = book.Find(enter.Guid);
        uint error = character switch
        {
            null => UnknownCharacter,
            _ when enter.Account != client.Account || character.Account != client.Account => NotYours,
            { IsOnline: true } => StillInWorld,
            _ => 0,
        };
        if (error == 0 && !server.Stage.TryEnter(client, character!)) error = CannotBePlaced;
        if (error != 0) client.Send(new CharacterError(error));
        else book.MoveToFront(character!);
    }
}
