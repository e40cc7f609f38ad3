// Blocks of numbers: base64 of zlib-compressed bytes, decoded when they are first asked for.
import type { Numbers } from "./format";

export type NumberArray = Float64Array | Float32Array | Uint32Array | Uint16Array | Uint8Array;

/** Decoded bytes are kept up to this size, the least recently used are dropped first. */
const CACHE_BYTES = 192 * 1024 * 1024;

const READERS = {
  f64: Float64Array,
  f32: Float32Array,
  u32: Uint32Array,
  u16: Uint16Array,
  u8: Uint8Array,
} as const;

function bytesOfBase64(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

export async function inflate(base64: string): Promise<ArrayBuffer> {
  const packed = new Blob([bytesOfBase64(base64.trim())]).stream();
  return new Response(packed.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();
}

/** A view of the numbers in a decoded block; a copy where the place does not fit the type. */
export function view(bytes: ArrayBuffer, numbers: Numbers): NumberArray {
  const reader = READERS[numbers.type];
  const size = reader.BYTES_PER_ELEMENT * numbers.count;
  if (numbers.offset + size > bytes.byteLength) {
    throw new Error(`block "${numbers.block}" ends before its numbers do`);
  }
  if (numbers.offset % reader.BYTES_PER_ELEMENT === 0) {
    return new reader(bytes, numbers.offset, numbers.count);
  }
  return new reader(bytes.slice(numbers.offset, numbers.offset + size));
}

interface Decoded {
  bytes: Promise<ArrayBuffer>;
  size: number;
}

export class Blocks {
  private readonly cache = new Map<string, Decoded>();
  private cachedBytes = 0;

  /** `given` holds the blocks of live data; a page that is a file has them in script elements. */
  constructor(private given: Record<string, string> | null) {}

  /** New live data: blocks that have not changed stay decoded. */
  replace(given: Record<string, string>): void {
    const old = this.given ?? {};
    this.given = given;
    for (const name of [...this.cache.keys()]) {
      if (old[name] !== given[name]) this.drop(name);
    }
  }

  async numbers(numbers: Numbers): Promise<NumberArray> {
    if (numbers.count === 0) return new READERS[numbers.type](0);
    return view(await this.bytes(numbers.block), numbers);
  }

  private bytes(name: string): Promise<ArrayBuffer> {
    const known = this.cache.get(name);
    if (known) {
      this.cache.delete(name);
      this.cache.set(name, known);
      return known.bytes;
    }
    const decoded: Decoded = { bytes: inflate(this.text(name)), size: 0 };
    this.cache.set(name, decoded);
    decoded.bytes.then(
      (bytes) => this.account(name, decoded, bytes.byteLength),
      () => this.cache.delete(name),
    );
    return decoded.bytes;
  }

  private text(name: string): string {
    const text = this.given
      ? this.given[name]
      : document.getElementById(`block:${name}`)?.textContent;
    if (typeof text !== "string") throw new Error(`block "${name}" is missing`);
    return text;
  }

  private account(name: string, decoded: Decoded, size: number): void {
    if (this.cache.get(name) !== decoded) return;
    decoded.size = size;
    this.cachedBytes += size;
    for (const other of this.cache.keys()) {
      if (this.cachedBytes <= CACHE_BYTES || other === name) break;
      this.drop(other);
    }
  }

  private drop(name: string): void {
    this.cachedBytes -= this.cache.get(name)?.size ?? 0;
    this.cache.delete(name);
  }
}
