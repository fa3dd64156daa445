// The whole text of a chart in the fragment of an address, which no browser sends to any server.

const MARK = "chart=";

// No chart is longer; a short link could be made to unfold to gigabytes.
const LONGEST = 1 << 20;

class TooLong extends Error {}

async function through(stream, bytes) {
  const writer = stream.writable.getWriter();
  const written = writer.write(bytes).then(() => writer.close());
  const [out] = await Promise.all([gathered(stream.readable.getReader()), written]);
  return out;
}

async function gathered(reader) {
  const parts = [];
  let length = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > LONGEST) {
      await reader.cancel();
      throw new TooLong("it holds more than a megabyte");
    }
    parts.push(value);
  }
  const out = new Uint8Array(length);
  parts.reduce((at, part) => (out.set(part, at), at + part.length), 0);
  return out;
}

export async function packed(text) {
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(text));
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return MARK + btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

// Nothing where the fragment holds no chart; an error where it cannot be read.
export async function unpacked(fragment) {
  const code = fragment.replace(/^#/, "");
  if (!code.startsWith(MARK)) {
    if (/^chart[^=]*=/.test(code)) throw new Error("it was made by another version of this page");
    return null;
  }
  try {
    const binary = atob(code.slice(MARK.length).replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = await through(new DecompressionStream("deflate-raw"), Uint8Array.from(binary, c => c.charCodeAt(0)));
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch (error) {
    if (error instanceof TooLong) throw error;
    throw new Error("it is damaged or was cut off. Copy the whole link once more");
  }
}
