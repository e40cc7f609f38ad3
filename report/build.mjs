// Makes dist/page.html (the page without data) and dist/player.js (WebGL, for pages with
// particles).
// Usage: node build.mjs [--out FOLDER], or --unit for the tests that run in Node
import { build } from "esbuild";
import { mkdir, readFile, readdir, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const given = process.argv.indexOf("--out");
const out = given > 0 ? process.argv[given + 1] : join(here, "dist");
const MARKS = ["@@TITLE@@", "@@DATA@@", "@@PLAYER@@"];

async function bundle(entry) {
  const result = await build({
    entryPoints: [join(here, "src", entry)],
    absWorkingDir: here,
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: ["es2022"],
    charset: "utf8",
    legalComments: "none",
    logLevel: "warning",
    define: { "process.env.NODE_ENV": '"production"' },
  });
  return result.outputFiles[0].text.trim();
}

/** The licences of what a bundle contains: both libraries ask for their notice in every copy. */
async function notice(name) {
  const licence = (await readFile(join(here, "node_modules", name, "LICENSE"), "utf8")).trim();
  return `/*! This contains ${name}:\n${licence}\n*/\n`;
}

function fill(template, mark, text) {
  const parts = template.split(mark);
  if (parts.length !== 2) throw new Error(`${mark} occurs ${parts.length - 1} times`);
  return parts.join(text);
}

function checkMarks(page) {
  for (const mark of MARKS) {
    const count = page.split("\n").filter((line) => line.trim() === mark).length;
    if (count !== 1 || page.split(mark).length !== 2)
      throw new Error(`${mark} must occur once, on a line of its own`);
  }
}

/** The tests of test/, with the sources that they ask, for Node itself. */
async function bundleTests() {
  const folder = join(here, "test");
  const files = (await readdir(folder)).filter((name) => name.endsWith(".test.mjs"));
  await build({
    entryPoints: files.map((name) => join(folder, name)),
    absWorkingDir: here,
    bundle: true,
    platform: "node",
    format: "esm",
    outExtension: { ".js": ".mjs" },
    outdir: join(here, "build", "unit"),
    logLevel: "warning",
  });
}

if (process.argv.includes("--unit")) {
  await bundleTests();
  process.exit(0);
}

const style = await bundle("theme/page.css");
const script = await bundle("page.ts");
const player = await bundle("player/scene.ts");
for (const text of [style, script, player]) {
  if (/<\/(script|style)/i.test(text) || /<!--/.test(text))
    throw new Error("a bundle would end its own element");
}
let page = await readFile(join(here, "src", "page.html"), "utf8");
page = fill(page, "/* style */", style);
page = fill(page, "/* script */", (await notice("uplot")) + script);
checkMarks(page);
await mkdir(out, { recursive: true });
await writeFile(join(out, "page.html"), page);
await writeFile(join(out, "player.js"), (await notice("three")) + player + "\n");
const size = (text) => `${Math.round(Buffer.byteLength(text) / 1000)} kB`;
console.log(
  `page.html ${size(page)} (script ${size(script)}, style ${size(style)}), player.js ${size(player)}`,
);
