// One file: script and style sheet move into the page, the licences of what is bundled in front.
import { readFileSync } from 'node:fs';
import { defineConfig } from 'vite';

const bundled = ['three', 'uplot'];

function licences() {
  const texts = bundled.map((name) => {
    const text = readFileSync(`node_modules/${name}/LICENSE`, 'utf8').trim();
    return `${name}\n${text}`;
  });
  return `<!--\nThis page contains:\n\n${texts.join('\n\n')}\n-->`;
}

function singleFile() {
  return {
    name: 'single-file',
    enforce: 'post',
    generateBundle(_options, bundle) {
      const page = bundle['index.html'];
      let html = page.source;
      for (const [name, part] of Object.entries(bundle)) {
        if (part.type === 'chunk') {
          const code = part.code.trim().replace(/<\/(script)/gi, '<\\/$1');
          const tag = /\s*<script type="module"[^>]*src="[^"]*"[^>]*><\/script>/;
          html = html.replace(tag, '');
          html = html.replace('</body>', () => `<script type="module">${code}</script>\n</body>`);
          delete bundle[name];
        } else if (name.endsWith('.css')) {
          html = html.replace(
            /<link rel="stylesheet"[^>]*>/,
            () => `<style>${part.source}</style>`,
          );
          delete bundle[name];
        }
      }
      html = html.replace('<html', () => `${licences()}\n<html`);
      page.source = html;
      page.fileName = 'page.html';
    },
  };
}

export default defineConfig({
  base: './',
  build: {
    target: 'es2022',
    modulePreload: false,
    assetsInlineLimit: Number.MAX_SAFE_INTEGER,
    cssCodeSplit: false,
    chunkSizeWarningLimit: 2000,
    reportCompressedSize: false,
  },
  plugins: [singleFile()],
});
