// Chromium without a window, spoken to over two pipes in the DevTools protocol: JSON in both directions, each message ended
// by a zero byte. That is all a test needs that only opens pages, so it needs no package of npm's.
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {spawn} from 'node:child_process';

const options = ['--headless=new', '--remote-debugging-pipe',
  '--no-sandbox',  // which root cannot have; the pages are our own
  '--disable-gpu', '--disable-dev-shm-usage',  // there may be no graphics card, and little shared memory in a container
  // Chromium's own errands would look like requests of the page, or wait for a network.
  '--disable-quic', '--no-first-run', '--no-default-browser-check', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--disable-extensions',
  // A tab that no one looks at draws all the same, so that what waits to be seen is seen.
  '--disable-backgrounding-occluded-windows', '--disable-renderer-backgrounding', '--disable-background-timer-throttling'];

/// A Chromium that knows nothing of its user: its home is a new folder, which goes when it goes.
export class Chromium {
  #waiting = new Map();  // the number of a command: how to answer it
  #tabs = new Map();     // the name of a session: what its events are told
  #sent = 0;
  #said = '';
  #ended;

  constructor(executable) {
    this.home = mkdtempSync(join(tmpdir(), 'tumble-chromium-'));
    this.process = spawn(executable, [...options, `--user-data-dir=${this.home}`], {
      stdio: ['ignore', 'ignore', 'pipe', 'pipe', 'pipe'],
      env: {...process.env, HOME: this.home, XDG_CONFIG_HOME: this.home, XDG_CACHE_HOME: this.home},
      detached: true,  // a group of its own, with which its helpers end too
    });
    const [, , complaints, commands, answers] = this.process.stdio;
    complaints.setEncoding('utf8').on('data', text => { this.#said = (this.#said + text).slice(-2000); });
    commands.on('error', () => {});  // it has ended, which is told below
    let begun = '';
    answers.setEncoding('utf8').on('data', text => {
      const messages = (begun + text).split('\0');
      begun = messages.pop();
      for (const message of messages) this.#hear(JSON.parse(message));
    });
    const end = reason => {
      this.#ended ??= new Error(`Chromium ended: ${reason}\n${this.#said}`);
      for (const {failed} of this.#waiting.values()) failed(this.#ended);
      this.#waiting.clear();
    };
    this.gone = new Promise(done => {
      this.process.on('error', error => { end(error.message); done(); });
      this.process.on('close', (code, signal) => { end(signal ?? `exit code ${code}`); done(); });
    });
    // Killed outright this process can do nothing more, but then the pipes are closed, at which Chromium ends by itself.
    process.on('exit', () => this.#kill());
    for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.once(signal, () => process.exit(1));
  }

  #hear({id, sessionId, method, params, result, error}) {
    if (method) return this.#tabs.get(sessionId)?.(method, params);
    const {done, failed, command} = this.#waiting.get(id) ?? {};
    this.#waiting.delete(id);
    if (error) failed?.(new Error(`${command}: ${error.message}`));
    else done?.(result);
  }

  #send(command, params, sessionId) {
    if (this.#ended) return Promise.reject(this.#ended);
    return new Promise((done, failed) => {
      const id = ++this.#sent;
      this.#waiting.set(id, {done, failed, command});
      this.process.stdio[3].write(`${JSON.stringify({id, sessionId, method: command, params})}\0`);
    });
  }

  /// A new tab: `send(command, params)` answers with the result, and `listen(method, params)` is told the tab's events.
  async open_tab(listen) {
    const {targetId} = await this.#send('Target.createTarget', {url: 'about:blank', newWindow: true, width: 1280, height: 900});
    const {sessionId} = await this.#send('Target.attachToTarget', {targetId, flatten: true});
    this.#tabs.set(sessionId, listen);
    return {send: (command, params = {}) => this.#send(command, params, sessionId)};
  }

  async close() {
    await this.#send('Browser.close').catch(() => {});
    const patience = setTimeout(() => this.#kill(), 20_000);
    await this.gone;
    clearTimeout(patience);
    this.#kill();
  }

  #kill() {
    try {
      process.kill(-this.process.pid, 'SIGKILL');
    } catch { /* it has ended */ }
    rmSync(this.home, {recursive: true, force: true, maxRetries: 10});
  }
}
