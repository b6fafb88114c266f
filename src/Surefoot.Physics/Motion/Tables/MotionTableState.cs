namespace Surefoot.Physics.Motion;

/// <summary>A motion with a speed.</summary>
internal readonly record struct MotionSpeed(MotionCommand Motion, float Speed);

/// <summary>Where a body is in its motion table.</summary>
/// <remarks>Retail: MotionState.</remarks>
internal sealed class MotionTableState
{
    private readonly List<MotionSpeed> modifiers = [];
    private readonly RingQueue<MotionSpeed> actions = new();

    /// <summary>Style; none before the default state is set.</summary>
    public MotionCommand Style { get; set; }

    /// <summary>Substate; none before the default state is set.</summary>
    public MotionCommand Substate { get; set; }

    /// <summary>Speed of the substate.</summary>
    public float SubstateSpeed { get; set; } = 1f;

    /// <summary>Number of modifiers on.</summary>
    public int ModifierCount => modifiers.Count;

    /// <summary>Number of actions that wait.</summary>
    public int ActionCount => actions.Count;

    /// <summary>A modifier, the newest at 0.</summary>
    public MotionSpeed GetModifier(int age) => modifiers[modifiers.Count - 1 - age];

    /// <summary>Puts a modifier on; false when it is on already or is the substate.</summary>
    public bool AddModifier(MotionCommand motion, float speed)
    {
        if (motion == Substate || IndexOf(motion) >= 0) return false;
        AddModifierUnchecked(motion, speed);
        return true;
    }

    /// <summary>Puts a modifier on.</summary>
    public void AddModifierUnchecked(MotionCommand motion, float speed) => modifiers.Add(new MotionSpeed(motion, speed));

    /// <summary>Finds a modifier that is on.</summary>
    public bool TryGetModifier(MotionCommand motion, out float speed)
    {
        int i = IndexOf(motion);
        speed = i < 0 ? 0f : modifiers[i].Speed;
        return i >= 0;
    }

    /// <summary>Takes a modifier off.</summary>
    public void RemoveModifier(MotionCommand motion)
    {
        int i = IndexOf(motion);
        if (i >= 0) modifiers.RemoveAt(i);
    }

    /// <summary>Takes all modifiers off.</summary>
    public void ClearModifiers() => modifiers.Clear();

    /// <summary>Appends an action.</summary>
    public void AddAction(MotionCommand motion, float speed) => actions.Enqueue(new MotionSpeed(motion, speed));

    /// <summary>Takes the oldest action off.</summary>
    public void RemoveAction()
    {
        if (actions.Count > 0) actions.Dequeue();
    }

    /// <summary>Takes all actions off.</summary>
    public void ClearActions() => actions.Clear();

    /// <summary>Becomes the same as another one.</summary>
    public void CopyFrom(MotionTableState other)
    {
        (Style, Substate, SubstateSpeed) = (other.Style, other.Substate, other.SubstateSpeed);
        modifiers.Clear();
        modifiers.AddRange(other.modifiers);
        actions.CopyFrom(other.actions);
    }

    /// <summary>Newest first, as retail's list is walked.</summary>
    private int IndexOf(MotionCommand motion)
    {
        for (int i = modifiers.Count - 1; i >= 0; i--)
            if (modifiers[i].Motion == motion) return i;
        return -1;
    }
}
