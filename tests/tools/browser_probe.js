// Measures the reports in this page's frames and writes what is wrong into the page.
'use strict';
var problems = [], checks = 0, label = '';
function check(ok, words) {
  checks += 1;
  if (!ok) problems.push(label + ': ' + words);
}
function colour(text) {
  var m = text.match(/[\d.]+/g).map(Number);
  return { r: m[0], g: m[1], b: m[2], a: m.length > 3 ? m[3] : 1 };
}
function luminance(c) {
  var part = [c.r, c.g, c.b].map(function (v) {
    v /= 255;
    return v <= 0.04045 ? v / 12.92 : Math.pow((v + 0.055) / 1.055, 2.4);
  });
  return 0.2126 * part[0] + 0.7152 * part[1] + 0.0722 * part[2];
}
function behind(node, view) {
  for (; node && node.nodeType === 1; node = node.parentNode) {
    var c = colour(view.getComputedStyle(node).backgroundColor);
    if (c.a === 1) return c;
  }
  return { r: 255, g: 255, b: 255, a: 1 };
}
// WCAG 2.2, 1.4.3: 4.5, or 3 for large text.
function contrast(doc, view) {
  var worst = 99, where = '';
  doc.querySelectorAll('body *').forEach(function (node) {
    if (node.closest('svg') || node.closest('.unseen') || node.closest('script')) return;
    var has_text = Array.from(node.childNodes).some(function (child) {
      return child.nodeType === 3 && child.textContent.trim() !== '';
    });
    if (!has_text || node.getClientRects().length === 0) return;
    var style = view.getComputedStyle(node);
    var a = luminance(colour(style.color)), b = luminance(behind(node, view));
    var ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    var size = parseFloat(style.fontSize), bold = Number(style.fontWeight) >= 700;
    var need = size >= 24 || (bold && size >= 18.66) ? 3 : 4.5;
    if (ratio / need < worst) {
      worst = ratio / need;
      where = node.tagName + '.' + node.className + ' ' + ratio.toFixed(2);
    }
  });
  check(worst >= 1, 'too little contrast: ' + where);
}
function widest(doc) {
  var limit = doc.documentElement.clientWidth, found = [];
  doc.querySelectorAll('body *').forEach(function (node) {
    if (node.closest('.unseen') || node.parentNode.closest('.scroll')) return;
    if (node.getBoundingClientRect().right > limit + 0.5) found.push(node.tagName + '.' + node.getAttribute('class'));
  });
  return found.slice(0, 6).join(' ');
}
function structure(doc) {
  ['header', 'main', 'footer'].forEach(function (name) {
    check(doc.querySelectorAll('body > ' + name).length === 1, 'one ' + name + ' is needed');
  });
  check(doc.querySelectorAll('h1').length === 1, 'one h1 is needed');
  check(doc.documentElement.lang !== '', 'no language');
  check(doc.title !== '', 'no title');
  var first = doc.querySelector('a');
  check(doc.querySelector(first.getAttribute('href')) !== null, 'the skip link leads nowhere');
  var level = 1;
  doc.querySelectorAll('h1,h2,h3,h4,h5').forEach(function (head) {
    var next = Number(head.tagName[1]);
    check(next <= level + 1, 'heading level skipped at "' + head.textContent.slice(0, 40) + '"');
    level = next;
  });
  doc.querySelectorAll('table').forEach(function (table) {
    check(table.caption !== null, 'table without caption');
    check(table.querySelector('th:not([scope])') === null, 'th without scope');
    check(table.querySelector('th[scope=col]') !== null || table.querySelector('th[scope=row]') !== null,
          'table without heads');
  });
  doc.querySelectorAll('input,select').forEach(function (field) {
    check(field.closest('label') !== null, 'field without label');
  });
  doc.querySelectorAll('img').forEach(function (image) { check(image.alt !== '', 'img without alt'); });
  doc.querySelectorAll('[role=img]').forEach(function (image) {
    check(image.hasAttribute('aria-label'), 'picture without words');
  });
  doc.querySelectorAll('.scroll').forEach(function (box) {
    check(box.tabIndex === 0, 'scroll box that keys cannot reach');
    check(box.getAttribute('aria-label') !== '', 'scroll box without name');
  });
  var ids = {};
  doc.querySelectorAll('[id]').forEach(function (node) {
    check(!Object.hasOwn(ids, node.id), 'id twice: ' + node.id);
    ids[node.id] = true;
  });
}
function visible(table) {
  return Array.from(table.querySelectorAll('tr.finding')).filter(function (row) { return !row.hidden; });
}
function sorting(doc, view) {
  var table = doc.querySelector('table.summary');
  if (table === null) return;
  var before = visible(table).map(function (row) { return row.textContent; }).join('|');
  var heads = Array.from(table.tHead.rows[0].cells);
  var column = heads.findIndex(function (head) { return /^(Margin|Reserve)/.test(head.textContent); });
  var button = heads[column].querySelector('button');
  check(button !== null, 'the script did not run');
  if (button === null) return;
  button.click();
  var margins = visible(table).map(function (row) {
    var cell = row.cells[column];
    return cell && cell.dataset.v ? Number(cell.dataset.v) : Infinity;
  });
  check(margins.every(function (m, i) { return i === 0 || margins[i - 1] <= m; }), 'not sorted by margin');
  check(heads[column].getAttribute('aria-sort') === 'ascending', 'no aria-sort');
  button.click();
  button.click();
  check(visible(table).map(function (row) { return row.textContent; }).join('|') === before,
        'the first order does not come back');
  var select = doc.querySelector('#summary-tools select');
  select.value = 'fail';
  select.dispatchEvent(new view.Event('change'));
  var rows = visible(table);
  check(rows.every(function (row) { return row.classList.contains('fail'); }), 'the filter keeps others');
  select.value = '';
  select.dispatchEvent(new view.Event('change'));
  var field = doc.querySelector('#summary-tools input');
  field.value = 'no such plane at all';
  field.dispatchEvent(new view.Event('input'));
  check(visible(table).length === 0, 'the text filter does nothing');
  field.value = '';
  field.dispatchEvent(new view.Event('input'));
}
function folding(doc) {
  var cards = doc.querySelectorAll('details.card');
  cards.forEach(function (card) {
    var fails = card.querySelector('tr.fail, tr.undecided') !== null;
    if (fails) check(card.open, 'a card that needs attention is folded');
  });
}
addEventListener('load', function () {
  var dark = matchMedia('(prefers-color-scheme: dark)').matches;
  document.querySelectorAll('iframe').forEach(function (frame) {
    var doc = frame.contentDocument, view = frame.contentWindow;
    label = (dark ? 'dark ' : 'light ') + frame.title;
    var wide = doc.documentElement.scrollWidth;
    check(wide <= frame.clientWidth, 'overflows by ' + (wide - frame.clientWidth) + ' px: ' + widest(doc));
    check(view.hacked === undefined, 'a name from a file ran as a script');
    if (frame.clientWidth !== 1400) return;
    structure(doc);
    folding(doc);
    contrast(doc, view);
    sorting(doc, view);
  });
  var result = document.getElementById('result');
  result.textContent = 'PROBE ' + (dark ? 'dark' : 'light') + ' ' + checks + ' checks, ' + problems.length +
    ' problems\n' + problems.slice(0, 40).join('\n');
});
