// One file: script and style sheet move into the page, the licences of what is bundled in front.
import { readFileSync, readdirSync } from 'node:fs';
import { defineConfig } from 'vite';

// The folders of the packages that a bundle's modules come from.
function packages(bundle) {
  const paths = Object.values(bundle).flatMap((part) => Object.keys(part.modules ?? {}));
  const folders = paths.map((path) => /.*\/node_modules\/(?:@[^/]+\/)?[^/]+/.exec(path)?.[0]);
  return [...new Set(folders.filter((folder) => folder))].sort();
}

function licences(bundle) {
  const texts = packages(bundle).map((folder) => {
    const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
    if (!file) throw new Error(`${folder} holds no licence, and the page needs its text`);
    const name = folder.split('/node_modules/').at(-1);
    return `${name}\n${readFileSync(`${folder}/${file}`, 'utf8').trim()}`;
  });
  return `<!--\nThis page contains:\n\n${texts.join('\n\n')}\n-->`;
}

function singleFile() {
  return {
    name: 'single-file',
    enforce: 'post',
    generateBundle(_options, bundle) {
      const head = licences(bundle);
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
      html = html.replace('<html', () => `${head}\n<html`);
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
