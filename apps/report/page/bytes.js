// What the page carries as base64 of deflated bytes, and numbers as it shows them.

async function inflated(text) {
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

/** A number with thin spaces between its thousands. */
function grouped(number) {
  return number.toLocaleString("en", { maximumSignificantDigits: 7 }).replaceAll(",", "\u202f");
}

/** A number with four digits at most. */
function rounded(value) {
  return Number.isFinite(value) ? grouped(Number(value.toPrecision(4))) : "";
}
