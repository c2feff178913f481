// A live figure's module: knobs and texts in, columns of numbers and words out. Works in a page and in node.
(() => {
  const live = (globalThis.tumble_live ??= {figures: {}, modules: {}});

  /** Whatever a module asks of a system. There is none; what is written goes nowhere, and an end is an error. */
  function imports_of(compiled) {
    const imports = {};
    for (const {module, name} of WebAssembly.Module.imports(compiled)) {
      imports[module] ??= {};
      imports[module][name] = name === 'proc_exit'
        ? () => { throw new Error('the module ended itself'); }
        : () => 8; // "no such file"
    }
    return imports;
  }

  class Module {
    #compiled;
    #exports;

    /** `bytes`: the module, as node's Buffer or a Uint8Array. */
    static async from(bytes) {
      const module = new Module();
      module.#compiled = await WebAssembly.compile(bytes);
      await module.#begin();
      return module;
    }

    async #begin() {
      const instance = await WebAssembly.instantiate(this.#compiled, imports_of(this.#compiled));
      this.#exports = instance.exports;
      this.#exports._initialize?.();
    }

    #text(at) {
      const bytes = new Uint8Array(this.#exports.memory.buffer, at);
      return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
    }

    #write(at, numbers) {
      new Float64Array(this.#exports.memory.buffer, at, numbers.length).set(numbers);
    }

    /** `texts` by their names. Of each: its name, a zero, how many bytes it has, a zero, its bytes. */
    #write_texts(texts) {
      const encoder = new TextEncoder();
      const parts = Object.entries(texts).flatMap(([name, text]) => {
        const bytes = encoder.encode(text);
        return [encoder.encode(`${name}\0${bytes.length}\0`), bytes];
      });
      const length = parts.reduce((total, part) => total + part.length, 0);
      let at = this.#exports.live_texts(length);
      for (const part of parts) {
        new Uint8Array(this.#exports.memory.buffer, at, part.length).set(part);
        at += part.length;
      }
    }

    /**
     * {knobs: [{name, unit, start, least, most}], texts: {NAME: its start}, columns: {NAME: Float64Array}, units: {NAME: unit},
     * said: {NAME: words}}, or {refusal} where the knobs cannot stand as they do. `values` in the order of the knobs; none: all
     * at their start; `texts` {NAME: words} that differ from their start. A module may do its work in parts: after each but the
     * last `between` is awaited with what it has said so far, and where it answers false the result is undefined.
     */
    async run(values = [], drawn = [], between = () => true, texts = {}) {
      for (;;) {
        const {goes_on, ...run} = await this.#run_part(values, drawn, texts);
        if (!goes_on) return run;
        if (!(await between(run.said))) return undefined;
      }
    }

    /** What one of the figure's own functions returns, called with numbers. */
    call(name, ...numbers) {
      return this.#exports[name](...numbers);
    }

    async #run_part(values, drawn, written) {
      try {
        this.#write(this.#exports.live_knobs(values.length), values);
        this.#write(this.#exports.live_drawn(drawn.length), drawn);
        this.#write_texts(written);
        const {goes_on, knobs, columns, texts, said} = JSON.parse(this.#text(this.#exports.live_run()));
        const {buffer} = this.#exports.memory;
        return {
          goes_on,
          knobs,
          texts,
          said,
          columns: Object.fromEntries(columns.map(({name, at, length}) => [name, new Float64Array(buffer, at, length).slice()])),
          units: Object.fromEntries(columns.map(({name, unit}) => [name, unit])),
        };
      } catch (error) {
        if (!(error instanceof WebAssembly.RuntimeError)) throw error;
        const refusal = this.#text(this.#exports.live_refusal()) || 'The memory of the page does not suffice.';
        await this.#begin(); // what broke off is not used again
        return {refusal};
      }
    }
  }

  /** The same from what a live program printed. */
  function run_of_program(text) {
    const {knobs, columns, texts, said} = JSON.parse(text);
    return {
      knobs,
      texts,
      said,
      columns: Object.fromEntries(columns.map(({name, values}) => [name, Float64Array.from(values, value => value ?? NaN)])),
      units: Object.fromEntries(columns.map(({name, unit}) => [name, unit])),
    };
  }

  Object.assign(live, {Module, run_of_program});
})();
