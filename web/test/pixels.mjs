// Pixels of a PNG, decoded by the browser, and the difference between two pictures.

export async function pixels(browser, png) {
  const page = await browser.newPage();
  try {
    const { width, height, text } = await page.evaluate(
      async (source) => {
        const image = new Image();
        image.src = source;
        await image.decode();
        const canvas = document.createElement('canvas');
        [canvas.width, canvas.height] = [image.width, image.height];
        const context = canvas.getContext('2d');
        context.drawImage(image, 0, 0);
        const { data } = context.getImageData(0, 0, image.width, image.height);
        let raw = '';
        for (let i = 0; i < data.length; i += 32768)
          raw += String.fromCharCode(...data.subarray(i, i + 32768));
        return { width: image.width, height: image.height, text: btoa(raw) };
      },
      `data:image/png;base64,${png.toString('base64')}`,
    );
    return { width, height, data: Buffer.from(text, 'base64') };
  } finally {
    await page.close();
  }
}

/** Fraction of the pixels whose colours differ clearly. */
export function differing(a, b) {
  if (a.width !== b.width || a.height !== b.height) return 1;
  let count = 0;
  for (let i = 0; i < a.data.length; i += 4)
    if ([0, 1, 2].some((k) => Math.abs(a.data[i + k] - b.data[i + k]) > 16)) count += 1;
  return count / (a.width * a.height);
}
