// browsers.mjs - starts browsers that Debian packages, each with a temporary profile.

import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import puppeteer from "puppeteer-core";

const CHROMIUM = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync"];
// Disables the network requests of Firefox. Arguments above do the same for Chromium.
const QUIET = { "datareporting.policy.dataSubmissionEnabled": false, "app.update.enabled": false,
  "network.captive-portal-service.enabled": false, "network.connectivity-service.enabled": false,
  "extensions.getAddons.cache.enabled": false, "browser.safebrowsing.update.enabled": false };

const setups = {
  chromium: (profile) => ({ browser: "chrome", executablePath: "/usr/bin/chromium",
    userDataDir: profile, args: CHROMIUM }),
  firefox: (profile) => ({ browser: "firefox", executablePath: "/usr/bin/firefox-esr",
    userDataDir: profile, extraPrefsFirefox: QUIET }),
};

/** Starts the browser NAME. Returns the browser and a function that ends it and removes its
 * profile. */
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
