// Sorting, filtering and printing. The page is complete without it. This file must hold neither
// "less than" nor "ampersand", so that the page stays well-formed XML.
(function () {
  'use strict';
  var table = document.querySelector('table.summary');
  var tools = document.getElementById('summary-tools');
  addEventListener('beforeprint', function () {
    document.querySelectorAll('details:not(.grid)').forEach(function (d) { d.open = true; });
  });
  if (table === null) return;

  var rows = Array.from(table.querySelectorAll('tr.finding'));
  var groups = Array.from(table.querySelectorAll('tr.group'));
  var homes = rows.map(function (row) { return row.parentNode; });
  var sorted = document.createElement('tbody');
  var state = { column: -1, turn: 1 };

  // Columns of names: "10" comes after "5a", and letters with marks beside those without.
  var names = new Set([0, 1, 2]);

  function key(row, column) {
    var cell = row.cells[column];
    if (cell === undefined) return null;
    var value = cell.getAttribute('data-v');
    if (value === null) return null;
    if (value === '') return null;
    var number = Number(value);
    return Number.isNaN(number) ? value.toLowerCase() : number;
  }
  function compare(a, b) {
    var x = key(a, state.column), y = key(b, state.column);
    if (x === null) return y === null ? 0 : 1;
    if (y === null) return -1;
    if (names.has(state.column)) {
      return state.turn * String(x).localeCompare(String(y), document.documentElement.lang, { numeric: true });
    }
    if (typeof x !== typeof y) { x = String(x); y = String(y); }
    return x > y ? state.turn : y > x ? -state.turn : 0;
  }
  function arrange() {
    var heads = table.tHead.rows[0].cells;
    Array.from(heads).forEach(function (head, i) {
      if (i === state.column) head.setAttribute('aria-sort', state.turn > 0 ? 'ascending' : 'descending');
      else head.removeAttribute('aria-sort');
    });
    rows.forEach(function (row, i) { homes[i].appendChild(row); });
    if (state.column >= 0) {
      rows.slice().sort(compare).forEach(function (row) { sorted.appendChild(row); });
      table.appendChild(sorted);
    } else if (sorted.parentNode !== null) {
      table.removeChild(sorted);
    }
    show();
  }
  function show() {
    var text = tools.querySelector('input').value.trim().toLowerCase();
    var verdict = tools.querySelector('select').value;
    var seen = 0;
    rows.forEach(function (row) {
      var fits = text === '' ? true : row.getAttribute('data-text').indexOf(text) > -1;
      if (verdict !== '') { if (!row.classList.contains(verdict)) fits = false; }
      row.hidden = !fits;
      if (fits) seen += 1;
    });
    groups.forEach(function (group) {
      var left = false;
      if (state.column === -1) {
        Array.from(group.parentNode.rows).forEach(function (row) {
          if (row.classList.contains('finding')) { if (!row.hidden) left = true; }
        });
      }
      group.hidden = !left;
    });
    var loose = seen !== rows.length;
    if (state.column >= 0) loose = true;
    table.classList.toggle('loose', loose);
    tools.querySelector('output').textContent =
      seen === rows.length ? rows.length + ' rows' : seen + ' of ' + rows.length + ' rows';
  }

  rows.forEach(function (row) {
    var home = row.parentNode.querySelector('tr.group');
    var of = home === null ? '' : home.textContent;
    row.setAttribute('data-text', (of + ' ' + row.textContent).toLowerCase());
  });
  Array.from(table.tHead.rows[0].cells).forEach(function (head, i) {
    if (!head.hasAttribute('data-sort')) return;
    var button = document.createElement('button');
    button.type = 'button';
    while (head.firstChild) button.appendChild(head.firstChild);
    head.appendChild(button);
    button.addEventListener('click', function () {
      if (state.column !== i) state = { column: i, turn: 1 };
      else if (state.turn === 1) state.turn = -1;
      else state = { column: -1, turn: 1 };
      arrange();
    });
  });
  tools.querySelector('input').addEventListener('input', show);
  tools.querySelector('select').addEventListener('change', show);
  tools.hidden = false;
  show();
})();
