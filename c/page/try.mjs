// The page driven in a headless Chromium: node c/page/try.mjs [PICTURE.png]
//
// Types callouts and values, as a person does, and compares what is shown. Needs Chromium and Node 20 or later, and nothing else: it
// speaks the browser's own protocol through a pipe.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const page = new URL("../../docs/fitcheck.html", import.meta.url);
const folder = mkdtempSync(join(tmpdir(), "fitcheck-page-"));
const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-sync",
  "--disable-component-update", "--remote-debugging-pipe", `--user-data-dir=${folder}`, "--window-size=720,760", "about:blank"];
const browser = spawn(process.env.CHROMIUM ?? "chromium", flags, { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
const waiting = new Map();
let number = 0, rest = "";
browser.stdio[4].on("data", some => {
  const parts = (rest + some).split("\0");
  rest = parts.pop();
  for (const part of parts) {
    const answer = JSON.parse(part);
    waiting.get(answer.id)?.(answer);
    waiting.delete(answer.id);
  }
});
const ask = (method, params = {}, sessionId) => new Promise((resolve, reject) => {
  number += 1;
  waiting.set(number, answer => answer.error ? reject(new Error(answer.error.message)) : resolve(answer.result));
  browser.stdio[3].write(JSON.stringify({ id: number, method, params, sessionId }) + "\0");
});
const limit = setTimeout(() => { console.error("the browser does not answer"); browser.kill(); process.exit(1); }, 120_000);

const { targetId } = await ask("Target.createTarget", { url: fileURLToPath(page).replace(/^/, "file://") });
const { sessionId } = await ask("Target.attachToTarget", { targetId, flatten: true });
const run = async expression => {
  const { result, exceptionDetails } = await ask("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true }, sessionId);
  if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
  return result.value;
};
const shown = id => run(`document.getElementById(${JSON.stringify(id)}).textContent`);
const type = async (id, text) => {
  await run(`document.getElementById(${JSON.stringify(id)}).focus(); document.getElementById(${JSON.stringify(id)}).select()`);
  if (text) await ask("Input.insertText", { text }, sessionId);
  else await ask("Input.dispatchKeyEvent", { type: "keyDown", key: "Delete", code: "Delete", windowsVirtualKeyCode: 46 }, sessionId);
};
const speak = code => run(`{ const list = document.getElementById("language"); list.value = "${code}"; list.dispatchEvent(new Event("input")); }`);

let failed = 0;
const expect = (found, wanted, what) => {
  if (wanted instanceof RegExp ? wanted.test(found) : found === wanted) return;
  failed += 1;
  console.error(`${what}: found ${JSON.stringify(found)}, wanted ${wanted}`);
};
for (let tries = 0; tries < 100 && !(await run("document.readyState === 'complete' && !!document.getElementById('refused')?.textContent")); tries += 1) {
  await new Promise(resolve => setTimeout(resolve, 100));
}
await speak("en");
expect(await shown("refused"), /25 H7/, "an empty page says what to type");
await type("callout", "25 H7");
expect(await shown("limits"), "25.000 … 25.021 mm", "limits alone");
expect(await shown("verdict"), "", "no verdict without a value");
for (const [value, verdict] of [["25.012", "✓ GOOD"], ["25,021", "✓ GOOD"], ["25.021001", "✕ SCRAP"], ["24.9915", "↻ REWORK"]]) {
  await type("measured", value);
  expect(await shown("verdict"), verdict, value);
}
expect(await shown("remove"), "Remove 8.5 µm", "what to remove");
await type("measured", "26.5");
expect(await shown("looks"), /outside the limits/, "what is far off says so");
expect(await shown("verdict"), "⚠ SCRAP", "and is not shown as sure");
await type("measured", "abc");
expect(await shown("refused"), /abc/, "no number is refused");
expect(await shown("verdict"), "", "and has no verdict");
await type("measured", "24.9915");
for (const [code, verdict] of [["de", "↻ NACHARBEIT"], ["nl", "↻ NABEWERKING"], ["it", "↻ RIPRESA"]]) {
  await speak(code);
  expect(await shown("verdict"), verdict, code);
  expect(await shown("limits"), "25,000 … 25,021 mm", `${code}, limits`);
}
await type("callout", "4000 H7");
expect(await shown("refused"), /3150/, "what is not defined is refused");
await speak("en");
await type("callout", "12 ±0.02");
await type("measured", "12.03");
expect(await shown("verdict"), "? OUT OF LIMITS", "neither hole nor shaft");
await type("callout", "25 H7");
await type("measured", "25.012");
if (process.argv[2]) {
  const { data } = await ask("Page.captureScreenshot", {}, sessionId);
  writeFileSync(process.argv[2], Buffer.from(data, "base64"));
}
clearTimeout(limit);
browser.kill();
await new Promise(resolve => browser.on("exit", resolve));
rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
if (failed) process.exit(1);
console.log("the page: well");
