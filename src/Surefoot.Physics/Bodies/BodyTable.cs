using System.Collections;

namespace Surefoot.Physics.Bodies;

/// <summary>Bodies by id, walked in retail's order: bucket by bucket, the newest of a bucket first.</summary>
/// <remarks>Retail: the object table of CObjectMaint, 128 buckets; specification 02, 4.2.</remarks>
internal sealed class BodyTable : IEnumerable<PhysicsBody>
{
    private const int Buckets = 128;

    private readonly List<PhysicsBody>[] buckets = new List<PhysicsBody>[Buckets];
    private readonly Dictionary<uint, PhysicsBody> byId = [];

    internal BodyTable()
    {
        for (int i = 0; i < Buckets; i++) buckets[i] = [];
    }

    internal void Add(PhysicsBody body)
    {
        byId.Add(body.Id, body);
        buckets[BucketOf(body.Id)].Insert(0, body);
    }

    internal void Remove(PhysicsBody body)
    {
        // Another body may have the id by now.
        if (!ReferenceEquals(Find(body.Id), body)) return;
        byId.Remove(body.Id);
        buckets[BucketOf(body.Id)].Remove(body);
    }

    internal PhysicsBody? Find(uint id) => byId.GetValueOrDefault(id);

    public Enumerator GetEnumerator() => new(this);

    IEnumerator<PhysicsBody> IEnumerable<PhysicsBody>.GetEnumerator() => GetEnumerator();

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    private static int BucketOf(uint id) => (int)((id ^ (id >> 8)) & (Buckets - 1));

    /// <summary>Walks the table without allocating.</summary>
    internal struct Enumerator(BodyTable table) : IEnumerator<PhysicsBody>
    {
        private int bucket;
        private int index = -1;

        public readonly PhysicsBody Current => table.buckets[bucket][index];

        readonly object IEnumerator.Current => Current;

        public bool MoveNext()
        {
            index++;
            while (bucket < Buckets && index >= table.buckets[bucket].Count)
            {
                bucket++;
                index = 0;
            }

            return bucket < Buckets;
        }

        public void Reset()
        {
            bucket = 0;
            index = -1;
        }

        public readonly void Dispose()
        {
        }
    }
}
