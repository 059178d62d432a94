// browsers.mjs - Debian's browsers, each with a profile of its own that is thrown away.

import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import puppeteer from "puppeteer-core";

const CHROMIUM = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync"];
// Firefox asks nobody for anything either.
const QUIET = { "datareporting.policy.dataSubmissionEnabled": false, "app.update.enabled": false,
  "network.captive-portal-service.enabled": false, "network.connectivity-service.enabled": false,
  "extensions.getAddons.cache.enabled": false, "browser.safebrowsing.update.enabled": false };

const setups = {
  chromium: (profile) => ({ browser: "chrome", executablePath: "/usr/bin/chromium",
    userDataDir: profile, args: CHROMIUM }),
  firefox: (profile) => ({ browser: "firefox", executablePath: "/usr/bin/firefox-esr",
    userDataDir: profile, extraPrefsFirefox: QUIET }),
};

/** A browser by name, and how to end it. */
export async function startBrowser(name) {
  const profile = mkdtempSync(join(tmpdir(), `c205-${name}-`));
  const browser = await puppeteer.launch({ headless: true, ...setups[name](profile) });
  return {
    browser,
    async end() {
      await browser.close();
      rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
    },
  };
}
