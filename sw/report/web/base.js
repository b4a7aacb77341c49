// SPDX-License-Identifier: Apache-2.0
// What all parts of the page share: the data, making elements, numbers for people.
'use strict';

const data = JSON.parse(document.getElementById('data').textContent);

/// The palette of Okabe and Ito: colours that colour-blind people can tell apart.
const kPalette = ['#e69f00', '#56b4e9', '#009e73', '#cc79a7', '#d55e00', '#0072b2', '#f0e442'];
const colourOf = (index) => kPalette[index % kPalette.length];

const kSvg = 'http://www.w3.org/2000/svg';

function fill(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else if (value === true) node.setAttribute(name, '');
    else if (value !== false && value !== null) node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}

/// An HTML element; strings among the children become text, never markup.
const element = (tag, attributes = {}, ...children) =>
  fill(document.createElement(tag), attributes, children);
const drawing = (tag, attributes = {}, ...children) =>
  fill(document.createElementNS(kSvg, tag), attributes, children);

const byId = (id) => document.getElementById(id);

const fixed = (value, digits) =>
  value === null || value === undefined ? '-' : value.toFixed(digits).replace(/^-(0(\.0+)?)$/, '$1');
const grouped = (value) => value.toLocaleString('en-US').replace(/,/g, '\u2009');
const plural = (count, one, many) => `${grouped(count)} ${count === 1 ? one : many}`;

/// A table in a box that scrolls sideways when the page is narrow. Columns: {head, number, title};
/// rows: lists of strings or nodes.
function table(columns, rows, attributes = {}) {
  const head = columns.map((c) => element('th', {
    scope: 'col', class: c.number ? 'number' : false, title: c.title || false}, c.head));
  const body = rows.map((row) => element('tr', row.attributes || {}, ...(row.cells || row).map(
    (cell, i) => element('td', {class: columns[i].number ? 'number' : false}, cell))));
  return element('div', {class: 'scroll'}, element('table', attributes,
    element('thead', {}, element('tr', {}, ...head)), element('tbody', {}, ...body)));
}

const swatch = (index) =>
  element('span', {class: 'swatch', style: `background:${colourOf(index)}`, 'aria-hidden': 'true'});

/// A heading, a caption of a sentence or two, and whatever follows, in place of what was there.
function section(id, head, caption, ...rest) {
  byId(id).replaceChildren(element('h2', {id: `${id}-head`}, head),
    element('p', {class: 'caption'}, caption), ...rest);
}
