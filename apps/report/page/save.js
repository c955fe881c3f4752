// What the reader takes from the page as files.

function save(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** Screen pixels a pixel of a saved picture: about 900 on its longer side, or one. */
function magnification(film, most) {
  return Math.max(1, Math.floor(most / Math.max(film.data.cols, film.data.rows)));
}

function film_as_png(film) {
  const factor = magnification(film, 900);
  const canvas = document.createElement("canvas");
  canvas.width = factor * film.data.cols;
  canvas.height = factor * film.data.rows;
  const context = canvas.getContext("2d");
  context.imageSmoothingEnabled = false;
  context.drawImage(film.picture, 0, 0, canvas.width, canvas.height);
  return new Promise((done) => canvas.toBlob(done, "image/png"));
}

/** Bytes of an animated GIF of the whole film, with a bar below that grows with the strain.
 *  @param told  called with the share that is done. */
async function film_as_gif(film, look, frames, told) {
  const factor = magnification(film, 600);
  const { cols, rows, end_strain } = film.data;
  const [width, bar] = [factor * cols, 6];
  const height = factor * rows + bar;
  const palette = [...film.palette(look), [255, 255, 255], [90, 98, 106]];
  const [paper, done] = [palette.length - 2, palette.length - 1];
  const encoder = gifenc.GIFEncoder();
  const image = new Uint8Array(width * height);
  for (let frame = 0; frame <= frames; ++frame) {
    const indices = film.indices((end_strain * frame) / frames);
    for (let y = 0; y < factor * rows; ++y)
      for (let x = 0; x < width; ++x) image[y * width + x] = indices[Math.floor(y / factor) * cols + Math.floor(x / factor)];
    image.fill(paper, width * factor * rows);
    for (let y = factor * rows + 2; y < height; ++y) image.fill(done, y * width, y * width + Math.round((width * frame) / frames));
    encoder.writeFrame(image, width, height, { palette, delay: frame === frames ? 2000 : 80 });
    told(frame / frames);
    await new Promise((next) => setTimeout(next));  // the page stays alive meanwhile
  }
  encoder.finish();
  return encoder.bytes();
}
