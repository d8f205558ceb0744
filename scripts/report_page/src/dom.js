// Elements of the page. Texts become text nodes: nothing from a file is ever read as markup.

function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes ?? {})) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? '' : value);
  }
  for (const child of children.flat()) if (child !== null && child !== undefined) element.append(child);
  return element;
}

export const h = (tag, attributes, ...children) => fill(document.createElement(tag), attributes, children);
export const svg = (tag, attributes, ...children) =>
  fill(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);

let sections = 0;

/** A section with its heading, to be filled. */
export function section(parent, heading, ...children) {
  const id = `section-${++sections}`;
  const element = h('section', { 'aria-labelledby': id }, h('h2', { id }, heading), ...children);
  parent.append(element);
  return element;
}

export const note = (...text) => h('p', { class: 'note' }, ...text);

/** rows: [[cell, …]]; a cell is a text or an element; `numeric` columns are set right. */
export function table(heads, rows, { numeric = [], caption } = {}) {
  const align = (i) => (numeric.includes(i) ? 'number' : undefined);
  return h(
    'div',
    { class: 'scrolls', tabindex: 0, role: 'region', 'aria-label': caption ?? 'table' },
    h(
      'table',
      null,
      caption ? h('caption', null, caption) : null,
      h('thead', null, h('tr', null, heads.map((head, i) => h('th', { scope: 'col', class: align(i) }, head)))),
      h(
        'tbody',
        null,
        rows.map((row) =>
          h('tr', null, row.map((cell, i) => (i === 0 ? h('th', { scope: 'row' }, cell) : h('td', { class: align(i) }, cell)))),
        ),
      ),
    ),
  );
}
