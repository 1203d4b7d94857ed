/** What a key of a link is: text for a field of `T`, or for a part of one. */

/** Text for a field; undefined where text is no value of it. What it means may depend on all of `T`. */
interface FieldCodec<T, Value> {
  encode(value: Value, all: T): string;
  parse(text: string, value: Value, all: T): Value | undefined;
}

/** A key of a link to a `T`, made by `keysOf`, which sees that the types of fields fit. */
export interface Key<T, Field extends PropertyKey = PropertyKey, Name extends string = string> {
  readonly key: Name;
  readonly field: Field;
  encode(of: T): string;
  /** The field with what the text says of it; undefined where that is nothing. */
  parse(text: string, of: T): unknown;
}

export function keysOf<T extends object>() {
  /** A key for a whole field. */
  function whole<K extends string, F extends keyof T>(
    key: K,
    field: F,
    { encode, parse }: FieldCodec<T, T[F]>,
  ): Key<T, F, K> {
    return {
      key,
      field,
      encode: (of) => encode(of[field], of),
      parse: (text, of) => parse(text, of[field], of),
    };
  }

  /** A key for a part of a field. */
  function part<K extends string, F extends keyof T, P extends keyof T[F]>(
    key: K,
    field: F,
    name: P,
    { encode, parse }: FieldCodec<T[F], T[F][P]>,
  ): Key<T, F, K> {
    return whole(key, field, {
      encode: (value) => encode(value[name], value),
      parse: (text, value) => {
        const changed = parse(text, value[name], value);
        return changed === undefined ? undefined : { ...value, [name]: changed };
      },
    });
  }

  return { whole, part };
}

/** What text says of a field, in the place of what it was; undefined where that is nothing. */
export function read<T extends object>({ field, parse }: Key<T>, text: string, of: T): T | undefined {
  const value = parse(text, of);
  return value === undefined ? undefined : { ...of, [field]: value };
}
