namespace Surefoot.Protocol.Messages;

/// <summary>The first number of a message. Numbers without a name here are passed on like all others.</summary>
public enum Opcode : uint
{
    /// <summary>Something was said nearby.</summary>
    HearSpeech = 0x02BB,

    /// <summary>A number of the character.</summary>
    PrivateUpdatePropertyInt = 0x02CD,

    /// <summary>A number of an object.</summary>
    PublicUpdatePropertyInt = 0x02CE,

    /// <summary>A 64-bit number of the character.</summary>
    PrivateUpdatePropertyInt64 = 0x02CF,

    /// <summary>A number of an object that names another object.</summary>
    PublicUpdatePropertyInstanceId = 0x02DA,

    /// <summary>A skill of the character.</summary>
    PrivateUpdateSkill = 0x02DD,

    /// <summary>The level of a skill of the character.</summary>
    PrivateUpdateSkillLevel = 0x02DF,

    /// <summary>An attribute of the character.</summary>
    PrivateUpdateAttribute = 0x02E3,

    /// <summary>Health, stamina or mana of the character, with its greatest value.</summary>
    PrivateUpdateVital = 0x02E7,

    /// <summary>Health, stamina or mana of the character as it is now.</summary>
    PrivateUpdateAttribute2ndLevel = 0x02E9,

    /// <summary>Position and movement of an object at once.</summary>
    PositionAndMovement = 0xF619,

    /// <summary>An object looks different.</summary>
    ObjDescEvent = 0xF625,

    /// <summary>The answer to <see cref="CharacterCreate"/>.</summary>
    CharacterCreateResponse = 0xF643,

    /// <summary>Leave the world, and the answer to it.</summary>
    CharacterLogOff = 0xF653,

    /// <summary>Create a character.</summary>
    CharacterCreate = 0xF656,

    /// <summary>Enter the world with a character.</summary>
    CharacterEnterWorld = 0xF657,

    /// <summary>The account's characters.</summary>
    CharacterList = 0xF658,

    /// <summary>A refusal.</summary>
    CharacterError = 0xF659,

    /// <summary>Asks again for an object's description.</summary>
    ForceObjDesc = 0xF6EA,

    /// <summary>An object appears, or is told anew.</summary>
    CreateObject = 0xF745,

    /// <summary>Which object is the player.</summary>
    PlayerCreate = 0xF746,

    /// <summary>An object is gone.</summary>
    DeleteObject = 0xF747,

    /// <summary>Where an object is.</summary>
    UpdatePosition = 0xF748,

    /// <summary>An object is held by another one.</summary>
    ParentEvent = 0xF749,

    /// <summary>An object left the world into somebody's hands or pack.</summary>
    PickupEvent = 0xF74A,

    /// <summary>Physics state of an object.</summary>
    SetState = 0xF74B,

    /// <summary>What an object does.</summary>
    UpdateMotion = 0xF74C,

    /// <summary>Velocity of an object.</summary>
    VectorUpdate = 0xF74E,

    /// <summary>A sound.</summary>
    Sound = 0xF750,

    /// <summary>The player is about to be teleported.</summary>
    PlayerTeleport = 0xF751,

    /// <summary>An effect, by its id.</summary>
    PlayScriptId = 0xF754,

    /// <summary>An effect, by its kind.</summary>
    PlayScriptType = 0xF755,

    /// <summary>The wrapper of ordered events (specification 08, 4.2).</summary>
    GameEvent = 0xF7B0,

    /// <summary>The wrapper of what a client does in the world (specification 08, 4.1).</summary>
    GameAction = 0xF7B1,

    /// <summary>The account is banned.</summary>
    AccountBanned = 0xF7C1,

    /// <summary>May a character enter the world?</summary>
    CharacterEnterWorldRequest = 0xF7C8,

    /// <summary>As <see cref="CreateObject"/>, but the object is made anew in any case.</summary>
    UpdateObject = 0xF7DB,

    /// <summary>The account is thrown out.</summary>
    AccountBoot = 0xF7DC,

    /// <summary>A character may enter the world.</summary>
    EnterWorldServerReady = 0xF7DF,

    /// <summary>A line of text from the server.</summary>
    Chat = 0xF7E0,

    /// <summary>Name of the server's world.</summary>
    ServerName = 0xF7E1,

    /// <summary>Which dat files does the client have?</summary>
    DddInterrogation = 0xF7E5,

    /// <summary>The answer to <see cref="DddInterrogation"/>.</summary>
    DddInterrogationResponse = 0xF7E6,

    /// <summary>Records of dat files follow.</summary>
    DddBegin = 0xF7E7,

    /// <summary>The exchange about dat files is over.</summary>
    DddEnd = 0xF7EA,
}

/// <summary>Type of what a client does in the world: the number inside <see cref="Opcode.GameAction"/>.</summary>
public enum GameActionType : uint
{
    /// <summary>Says something.</summary>
    Talk = 0x0015,

    /// <summary>Moves a thing into a container.</summary>
    PutItemInContainer = 0x0019,

    /// <summary>Takes a thing into the hand or puts it on.</summary>
    GetAndWieldItem = 0x001A,

    /// <summary>Drops a thing.</summary>
    DropItem = 0x001B,

    /// <summary>Uses an object.</summary>
    Use = 0x0036,

    /// <summary>Spends experience on health, stamina or mana.</summary>
    RaiseVital = 0x0044,

    /// <summary>Spends experience on an attribute.</summary>
    RaiseAttribute = 0x0045,

    /// <summary>Spends experience on a skill.</summary>
    RaiseSkill = 0x0046,

    /// <summary>Learns a skill.</summary>
    TrainSkill = 0x0047,

    /// <summary>Draws or sheathes the weapon.</summary>
    ChangeCombatMode = 0x0053,

    /// <summary>Has arrived: after entering the world and after every teleport.</summary>
    LoginComplete = 0x00A1,

    /// <summary>Looks at an object.</summary>
    IdentifyObject = 0x00C8,

    /// <summary>Asks for a sign of life.</summary>
    RequestPing = 0x01E9,

    /// <summary>The player jumped.</summary>
    Jump = 0xF61B,

    /// <summary>The player's keys changed.</summary>
    MoveToState = 0xF61C,

    /// <summary>Begins a motion, at autonomy level 0.</summary>
    DoMovementCommand = 0xF61E,

    /// <summary>Ends a motion, at autonomy level 0.</summary>
    StopMovementCommand = 0xF661,

    /// <summary>How much the client decides.</summary>
    AutonomyLevel = 0xF752,

    /// <summary>Where the player is.</summary>
    AutonomousPosition = 0xF753,

    /// <summary>Jumps, at autonomy level 0.</summary>
    JumpNonAutonomous = 0xF7C9,
}

/// <summary>Type of an ordered event: the number inside <see cref="Opcode.GameEvent"/>.</summary>
public enum GameEventType : uint
{
    /// <summary>A text to read and close.</summary>
    Popup = 0x0004,

    /// <summary>All of the character.</summary>
    PlayerDescription = 0x0013,

    /// <summary>The friends list.</summary>
    Friends = 0x0021,

    /// <summary>A thing went into a container.</summary>
    ItemServerSaysContainId = 0x0022,

    /// <summary>A thing was taken into the hand or put on.</summary>
    WieldItem = 0x0023,

    /// <summary>The character's titles.</summary>
    Titles = 0x0029,

    /// <summary>What was seen of an object that was looked at.</summary>
    IdentifyObjectResponse = 0x00C9,

    /// <summary>What is in a pack.</summary>
    ViewContents = 0x0196,

    /// <summary>A thing was put down.</summary>
    InventoryPutObjectIn3D = 0x019A,

    /// <summary>Using an object is over.</summary>
    UseDone = 0x01C7,

    /// <summary>The answer to <see cref="GameActionType.RequestPing"/>.</summary>
    PingResponse = 0x01EA,

    /// <summary>A remark by its number.</summary>
    WeenieError = 0x028A,

    /// <summary>A remark by its number, with a text.</summary>
    WeenieErrorWithString = 0x028B,

    /// <summary>Numbers of the chat channels.</summary>
    SetTurbineChatChannels = 0x0295,

    /// <summary>An enchantment began or changed.</summary>
    UpdateEnchantment = 0x02C2,

    /// <summary>An enchantment ended.</summary>
    RemoveEnchantment = 0x02C3,

    /// <summary>Several enchantments began or changed.</summary>
    UpdateMultipleEnchantments = 0x02C4,

    /// <summary>Several enchantments ended.</summary>
    RemoveMultipleEnchantments = 0x02C5,

    /// <summary>All enchantments ended.</summary>
    PurgeEnchantments = 0x02C6,
}
