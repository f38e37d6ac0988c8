// Opens report.html in headless Chromium: no error, no network, slider and keyboard work, letters are
// legible, and without WebGL or scripts the pictures remain.
//
//   node report_page.mjs REPORT.html [CASE NAME]
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const report = resolve(process.argv[2]);
const caseName = process.argv[3];
const address = pathToFileURL(report).href;
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const megabyte = 1024 * 1024;

const quiet = ['--headless', '--no-sandbox', '--no-first-run', '--disable-quic', '--disable-sync',
  '--disable-background-networking', '--disable-component-update', '--disable-dev-shm-usage'];
const softwareGl = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

// A browser of its own for each condition; what it says and asks for is kept.
async function withPage(flags, options, look) {
  const profile = mkdtempSync(join(tmpdir(), 'facetobone-browser-'));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
    args: [...quiet, ...flags],
    viewport: { width: 1200, height: 900 },
    ...options,
  });
  const said = [], asked = [];
  try {
    const page = await context.newPage();
    page.on('console', (message) => {
      // what the driver says of its own speed is not the page's
      const isDriver = message.text().includes('GPU stall due to ReadPixels');
      if (!isDriver && ['error', 'warning'].includes(message.type())) {
        said.push(message.text());
      }
    });
    page.on('pageerror', (error) => said.push(String(error)));
    page.on('dialog', (dialog) => { said.push('dialog: ' + dialog.message()); dialog.dismiss(); });
    page.on('request', (request) => {
      if (!/^(file|data|blob):/.test(request.url())) {
        asked.push(request.url());
      }
    });
    await page.goto(address, { waitUntil: 'load', timeout: 120000 });
    await look(page);
    assert.deepEqual(said, [], 'the console is silent');
    assert.deepEqual(asked, [], 'nothing is asked of any network address');
  } finally {
    await context.close();
    rmSync(profile, { recursive: true, force: true });
  }
}

// The canvas once it has drawn what was asked for last.
async function picture(page) {
  await page.evaluate(() => new Promise((done) =>
    requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done)))));
  return page.locator('#viewer-canvas').evaluate((canvas) => {
    const copy = document.createElement('canvas');
    copy.width = 300;
    copy.height = 200;
    const context = copy.getContext('2d');
    context.drawImage(canvas, 0, 0, 300, 200);
    return Array.from(context.getImageData(0, 0, 300, 200).data);
  });
}

function differing(a, b) {
  let count = 0;
  for (let i = 0; i < a.length; i += 4) {
    count += Math.abs(a[i] - b[i]) + Math.abs(a[i + 1] - b[i + 1]) + Math.abs(a[i + 2] - b[i + 2])
      > 24 ? 1 : 0;
  }
  return count;
}

function drawn(pixels) {
  return differing(pixels, pixels.map((_, i) => pixels[i % 4])); // against its own corner
}

async function testViewer(page) {
  await page.locator('#viewer').waitFor({ state: 'visible', timeout: 60000 });
  const predicted = await picture(page);
  assert.ok(drawn(predicted) > 6000, 'the head fills a good part of the view');

  const slider = page.locator('#viewer-state');
  await slider.focus();
  await page.keyboard.press('Home');
  const before = await picture(page);
  assert.ok(differing(before, predicted) > 150, 'the slider changes the picture');
  assert.equal(await page.locator('#viewer-state-text').textContent(), 'before');
  for (let i = 0; i < 50; ++i) {
    await page.keyboard.press('ArrowRight');
  }
  assert.equal(await page.locator('#viewer-state-text').textContent(), 'target');
  const target = await picture(page);
  assert.ok(differing(before, target) > 150, 'the target is another face than before');
  await page.keyboard.press('End');
  assert.equal(differing(await picture(page), predicted), 0, 'and comes back to the same');

  await page.locator('#viewer-canvas').focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowUp');
  const turned = await picture(page);
  assert.ok(differing(turned, predicted) > 500, 'arrow keys turn');
  await page.keyboard.press('+');
  assert.ok(differing(await picture(page), turned) > 500, 'plus zooms');
  await page.keyboard.press('Home');
  assert.equal(differing(await picture(page), predicted), 0, 'Home goes back');
  for (let view = 1; view <= 7; ++view) {
    const last = await picture(page);
    await page.keyboard.press(String(view));
    assert.ok(differing(await picture(page), last) > 500, `view ${view} is another one`);
    assert.ok(drawn(await picture(page)) > 4000, `the head is in view ${view}`);
  }
  await page.keyboard.press('Home');

  await page.locator('#viewer-map').check();
  assert.ok(differing(await picture(page), predicted) > 1000, 'the distance map colours the face');
  assert.ok(await page.locator('#viewer-scale').isVisible(), 'with its bar');
  await page.locator('#viewer-map').uncheck();
  await page.locator('#viewer-face').selectOption('veil');
  const veil = await picture(page);
  assert.ok(differing(veil, predicted) > 1000, 'the face can be translucent');
  await page.locator('#viewer-face').selectOption('none');
  const bones = await picture(page);
  assert.ok(differing(bones, veil) > 1000 && drawn(bones) > 2000, 'or hidden: bones remain');
  await slider.focus();
  await page.keyboard.press('Home');
  assert.ok(differing(await picture(page), bones) > 50, 'the fragments move');
  await page.locator('#viewer-bones').uncheck();
  assert.equal(drawn(await picture(page)), 0, 'and bones can be hidden');
  await page.locator('#viewer-bones').check();
  await page.locator('#viewer-face').selectOption('solid');
}

async function testTabOrder(page) {
  await page.evaluate(() => document.activeElement.blur());
  const reached = new Set();
  for (let i = 0; i < 80; ++i) {
    await page.keyboard.press('Tab');
    reached.add(await page.evaluate(() => document.activeElement.id));
  }
  for (const id of ['canvas', 'state', 'view', 'face', 'bones', 'map', 'play']) {
    assert.ok(reached.has('viewer-' + id), `Tab reaches ${id}`);
  }
}

async function testAccessibility(page) {
  await page.evaluate(axe);
  const found = await page.evaluate(() => axe.run(document, {
    runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa'],
  }));
  assert.ok(found.passes.some((rule) => rule.id === 'color-contrast'), 'contrast was looked at');
  assert.deepEqual(
    found.violations.map((v) => `${v.id}: ${v.nodes.slice(0, 3).map((n) => n.html).join(' | ')}`), []);
}

async function testText(page) {
  assert.match(await page.locator('body').innerText(), /Research software, not a medical device/);
  if (caseName) {
    assert.ok((await page.locator('.case').innerText()).includes(caseName), 'the name is text');
  }
  assert.equal(await page.locator('script').count(), 3, 'no scripts but ours');
}

async function testPicturesOnly(page) {
  assert.ok(!await page.locator('#viewer').isVisible());
  assert.ok(await page.locator('#viewer-none').isVisible(), 'why there is no view');
  const images = page.locator('figure img');
  assert.ok(await images.count() >= 8);
  for (const image of await images.all()) {
    const width = await image.evaluate((img) => img.naturalWidth).catch(() => 1);
    assert.ok(width > 0 && (await image.getAttribute('alt')).length > 5);
  }
}

const size = statSync(report).size;
assert.ok(size < 15 * megabyte, `${(size / megabyte).toFixed(1)} MB`);
await withPage(softwareGl, {}, async (page) => {
  await testText(page);
  await testViewer(page);
  await testTabOrder(page);
  await testAccessibility(page);
  if (process.env.SHOT) {
    await page.screenshot({ path: process.env.SHOT });
  }
});
await withPage(['--disable-gpu', '--disable-3d-apis'], {}, testPicturesOnly);
await withPage(['--disable-gpu'], { javaScriptEnabled: false }, testPicturesOnly);
console.log(`report page: all good, ${(size / megabyte).toFixed(1)} MB`);
