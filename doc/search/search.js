/* Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later */

// The field that searches the manual: all words of a query have to be in an entry, at least as the beginnings of
// words. search_index.js, which make_index.py writes, is loaded when the field is first used.

(() => {
  const most = 12, kinds = ['page', 'section', 'symbol', 'parameter'];
  const place = ([kind, , address]) => /^manual_(tools|evidence|thesis)/.test(address) ? .7
      : /^(index|manual_)/.test(address) ? 1.5 : /^group__PkgEntryPoints/.test(address) ? 1.2
      : kinds[kind] === 'parameter' ? .4 : /^(class|struct)/.test(address) ? .6
      : /^(md_doc_(CHANGELOG|errata|developers|fuzzing|mutations|thesis_map))/.test(address) ? .4 : 1;
  let loaded = null, sorted = null;

  function load() {
    loaded ??= new Promise((resolve, reject) => {
      const script = document.createElement('script');
      Object.assign(script, {src: 'search_index.js', onload: resolve, onerror: reject});
      document.head.append(script);
    }).then(() => {
      const {titles, texts} = window.searchIndex;
      sorted = {titles: Object.keys(titles).sort(), texts: Object.keys(texts).sort()};
    });
    return loaded;
  }

  const split = text => text.normalize('NFD').replace(/[\u0300-\u036f]/g, '').toLowerCase()
      .replace(/\(\)|cgp::|conformal_geometry_processing::|cgal::/g, ' ')
      .match(/[a-z0-9_]+(?:[-.:\/+][a-z0-9_]+)*/g) ?? [];

  /** What an entry is found by: a parameter by its own name. */
  const nameOf = ([kind, title]) => split(kinds[kind] === 'parameter' ? title.split(',')[0] : title).join(' ');

  /** The known words that begin so; of one letter, this alone. */
  function beginnings(words, begin) {
    let low = 0, high = words.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (words[middle] < begin) low = middle + 1;
      else high = middle;
    }
    const found = [], fits = word => begin.length > 1 ? word.startsWith(begin) : word === begin;
    while (low < words.length && fits(words[low])) found.push(words[low++]);
    return found;
  }

  /** What users type, by the word of the manual for it; and a word without its ending. */
  const others = Object.fromEntries(Object.entries({
    licence: 'license lgpl', cite: 'citation bibtex', colour: 'color', flatten: 'unwrap texture uv atlas',
    formats: 'glb gltf obj ply stl usd usda vtk', scale_bound: 'bound', handles: 'genus',
    first: 'tutorial getting started',
    installation: 'docker setup', install: 'pip', packages: 'conda', releases: 'version windows macos', entry: 'api',
    threads: 'openmp multithreading', npm: 'wasm webassembly javascript', studio: 'sculpt brush',
    inversions: 'mobius', repair: 'watertight', larger: 'mpi cluster',
    'quasi-conformal': 'q angle distortion', program: 'cli',
  }).flatMap(([word, typed]) => typed.split(' ').map(other => [other, word])));
  const stem = word => word.replace(/(ations?|ing|ed|s)$/, '');

  /** What the entries are worth for one word. */
  function worths(word) {
    const {titles, texts, entries} = window.searchIndex, worth = new Map();
    const add = (entry, value) => worth.set(entry, Math.max(worth.get(entry) ?? 0, value));
    const nearness = token => token === word ? 1 : token === `${word}s` ? .95 : .2 + .5 * word.length / token.length;
    for (const token of beginnings(sorted.titles, word))
      for (const entry of titles[token])
        add(entry, nearness(token) * (20 + 12 / nameOf(entries[entry]).split(/[ _]/).length));
    for (const token of beginnings(sorted.texts, word))
      for (let i = 0; i < texts[token].length; i += 2)
        add(texts[token][i], (2 + 2 * Math.log(texts[token][i + 1])) * nearness(token) * brevity(entries[texts[token][i]]));
    return worth;
  }

  /** A word tells more of a short text. */
  const brevity = ([, , , , , length]) => 2 / (1 + .5 * Math.log(1 + length / 40));

  /** And for what else it may mean, which is worth less. */
  function allWorths(word) {
    const worth = worths(word);
    for (const other of [stem(word), others[word]])
      if (other && other !== word && other.length > 2)
        for (const [entry, value] of worths(other)) worth.set(entry, Math.max(worth.get(entry) ?? 0, .8 * value));
    return worth;
  }

  function search(query) {
    const words = split(query);
    if (words.length === 0) return [];
    const each = words.map(allWorths);
    const {entries} = window.searchIndex, whole = words.join(' ');
    const found = [...each[0].keys()].filter(entry => each.every(worth => worth.has(entry)));
    const value = entry => {
      const [kind, title] = entries[entry], name = nameOf(entries[entry]).replace(/^the /, ''), page = kinds[kind] === 'page' ? 4 : 0;
      const exact = name === whole ? 30 : stem(name) === stem(whole) ? 20 : name.startsWith(whole) ? 6 : 0;
      return place(entries[entry]) * (exact + page + each.reduce((sum, worth) => sum + worth.get(entry), 0) - .02 * title.length);
    };
    const seen = new Set();
    return found.map(entry => [value(entry), entries[entry]]).sort(([a], [b]) => b - a)
        .map(([, entry]) => entry)
        .filter(([, title, address]) => !seen.has(title + address) && seen.add(title + address)).slice(0, most);
  }

  function row([kind, title, address, page, text]) {
    const link = document.createElement('a'), name = document.createElement('b'), rest = document.createElement('span');
    link.href = address;
    name.textContent = title;
    rest.textContent = [kinds[kind] === 'page' ? '' : page, text].filter(Boolean).join(': ');
    link.append(name, rest);
    return link;
  }

  function start() {
    const box = document.createElement('div'), field = document.createElement('input'), list = document.createElement('div');
    box.id = 'manual-search';
    list.id = 'manual-search-results';
    Object.assign(field, {type: 'search', id: 'manual-search-field', placeholder: 'Search: press /', autocomplete: 'off'});
    field.setAttribute('aria-label', 'search the manual');
    box.append(field, list);
    document.querySelector('#titlearea')?.append(box);
    const show = async () => {
      await load();
      const found = search(field.value);
      list.replaceChildren(...found.map(row));
      if (found.length === 0 && field.value.trim()) list.textContent = 'Nothing found';
      list.dataset.query = field.value;
    };
    field.addEventListener('focus', load, {once: true});
    field.addEventListener('input', show);
    field.addEventListener('keydown', event => {
      if (event.key === 'Enter') list.querySelector('a')?.click();
      if (event.key === 'Escape') {
        field.value = '';
        show();
      }
      event.stopPropagation(); // or doxygen's own keys take it
    });
    document.addEventListener('keydown', event => {
      if (event.key !== '/' || event.target.matches('input, textarea')) return;
      event.preventDefault();
      field.focus();
    });
  }

  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', start);
  else start();
})();
