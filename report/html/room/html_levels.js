// Levels of light that the reader moves: what planes would then have, as a preview. Values are
// linear in them. The page is complete without it, and nothing of it is printed. Like the other
// script it must hold neither "less than" nor "ampersand".
(function () {
  'use strict';
  var kMostDecimals = 9;
  var changes = [];  // of the page: how each is taken back
  var active = null;  // of the panel whose levels the page shows: how it is settled

  function put(node, name, value) {
    var old = node.getAttribute(name);
    changes.push(function () {
      if (old === null) node.removeAttribute(name); else node.setAttribute(name, old);
    });
    node.setAttribute(name, value);
  }
  function write(node, text) {
    var old = Array.from(node.childNodes);
    changes.push(function () { node.replaceChildren.apply(node, old); });
    node.replaceChildren(document.createTextNode(text));
  }
  function insert(parent, node, before) {
    changes.push(function () { node.remove(); });
    parent.insertBefore(node, before);
  }
  function add_class(node, name) {
    changes.push(function () { node.classList.remove(name); });
    node.classList.add(name);
  }
  function take_back() {
    changes.reverse().forEach(function (undo) { undo(); });
    changes = [];
  }

  // As format_cell of the program: three digits, and more until they are on their true side of
  // every limit.
  function limits_of(node) {
    var text = node.getAttribute('data-limits');
    if (text === null) return [];
    return text.split(';').map(function (one) {
      var parts = one.split(' ');
      return { comparison: parts[0], limit: Number(parts[1]) };
    });
  }
  function misses(limit, value) {
    if (limit.comparison === 'at_least') return limit.limit > value;
    if (limit.comparison === 'more_than') return !(value > limit.limit);
    if (limit.comparison === 'at_most') return value > limit.limit;
    return !(limit.limit > value);
  }
  function digits(value, fewest, most, limits) {
    var decimals = 1, text;
    if (value !== 0) decimals = Math.min(Math.max(fewest - 1 - Number(value.toExponential().split('e')[1]), 0), most);
    for (var tried = decimals; kMostDecimals >= tried; ++tried) {
      text = value.toFixed(tried);
      var shown = Number(text);
      if (limits.every(function (limit) { return misses(limit, shown) === misses(limit, value); })) return text;
    }
    return value.toFixed(decimals);
  }

  function numbers(text) { return text.split(' ').map(Number); }

  function read_plane(home) {
    var light = home.getAttribute('data-light').split(';').map(function (one) {
      var parts = one.split(':');
      return { group: Number(parts[0]), average: Number(parts[1]), values: numbers(parts[2]) };
    });
    var scale = home.getAttribute('data-scale'), cells = home.getAttribute('data-cells');
    var matrix = home.querySelector('table.matrix'), list = home.querySelectorAll('table.points td.strong');
    var places = cells === null ? null : numbers(cells), all = matrix === null ? [] : matrix.tBodies[0].querySelectorAll('td');
    return {
      home: home, article: home.closest('.plane'), light: light, limits: limits_of(home), unit: home.getAttribute('data-unit'),
      borders: scale === null ? [] : numbers(scale),  // the lower one of every colour
      colours: scale === null ? [] : home.getAttribute('data-colours').split(' '),
      inks: scale === null ? [] : home.getAttribute('data-inks').split(' '),
      is_list: places === null, title: home.closest('.plane').querySelector('h4').textContent.trim(),
      limit_words: home.getAttribute('data-limit-words'),
      cells: places === null ? Array.from(list) : matrix === null ? [] : places.map(function (place) { return all[place]; })
    };
  }

  function draw(plane, values, words) {
    var svg = plane.home.querySelector('svg.plan');
    if (svg === null) return;
    put(svg, 'aria-label', plane.title + ', ' + words.preview);
    var cells = svg.querySelectorAll('.cells path'), texts = svg.querySelectorAll('.numbers text');
    var hatched = '', lowest = 0;
    values.forEach(function (value, i) {
      var band = Math.max(plane.borders.filter(function (border) { return value >= border * (1 - 1e-9); }).length - 1, 0);
      put(cells[i], 'fill', plane.colours[band]);
      put(cells[i], 'stroke', plane.colours[band]);
      var text = words.number(digits(value, 3, 3, plane.limits));
      write(cells[i].querySelector('title'), text + ' ' + plane.unit + ', ' + words.preview);
      if (texts.length > i) {
        put(texts[i], 'fill', plane.inks[band]);
        put(texts[i], 'stroke', plane.colours[band]);
        write(texts[i], text);
      }
      if (plane.limits.some(function (limit) { return misses(limit, value); })) hatched += cells[i].getAttribute('d');
      if (values[lowest] > value) lowest = i;
    });
    var old = svg.querySelector('.missed');
    if (old !== null) put(old, 'd', hatched);
    else if (hatched !== '') {
      var path = document.createElementNS(svg.namespaceURI, 'path');
      path.setAttribute('class', 'missed');
      path.setAttribute('fill', svg.querySelector('pattern').id === '' ? 'none' : 'url(#' + svg.querySelector('pattern').id + ')');
      path.setAttribute('d', hatched);
      var last = cells[cells.length - 1].parentNode;
      insert(last.parentNode, path, last.nextSibling);
    }
    svg.querySelectorAll('.min-halo,.min-mark').forEach(function (mark) { put(mark, 'd', cells[lowest].getAttribute('d')); });
  }

  function tabulate(plane, values, words) {
    plane.cells.forEach(function (cell, i) {
      write(cell, words.number(digits(values[i], 3, 3, plane.limits)) + (plane.is_list ? ' ' + plane.unit : ''));
    });
    plane.home.querySelectorAll('table.points td.part').forEach(function (cell) { write(cell, '–'); });
  }

  function state(plane, values, average, words) {
    var lowest = Math.min.apply(null, values), highest = Math.max.apply(null, values);
    var of = { average: average, minimum: lowest, maximum: highest,
      Uo: average > 0 ? lowest / average : NaN, Ud: highest > 0 ? lowest / highest : NaN };
    var brief = words.preview;
    plane.home.querySelectorAll('tr[data-statistic]').forEach(function (row) {
      var name = row.getAttribute('data-statistic'), value = of[name], is_ratio = name.charAt(0) === 'U';
      var text = Number.isNaN(value) ? '–' : is_ratio ? digits(value, 3, 3, limits_of(row)) :
        digits(value, 3, 3, limits_of(row)) + ' ' + plane.unit;
      text = words.number(text);
      if (name === 'average') brief += ': Ē ' + text;
      if (name === 'Uo') brief += ' · Uo ' + text;
      write(row.cells[1], text);
      write(row.cells[2], words.preview);
    });
    var summary = document.createElement('span');
    summary.className = 'brief-preview';
    summary.textContent = brief;
    insert(plane.home.parentNode.querySelector('summary'), summary, null);
  }

  function note(article, home, text) {
    add_class(article, 'preview');
    var line = document.createElement('p');
    line.className = 'message';
    line.textContent = text;
    insert(home, line, home.firstChild);
  }

  function show(plane, levels, factor, words) {
    var average = 0, values = plane.light[0].values.map(function () { return 0; });
    plane.light.forEach(function (light) {
      var level = levels[light.group] * factor;
      average += level * light.average;
      light.values.forEach(function (value, i) { values[i] += level * value; });
    });
    var is_missed = values.some(function (value) { return plane.limits.some(function (limit) { return misses(limit, value); }); });
    note(plane.article, plane.home, is_missed ? words.note + ' ' + words.missed.replace('{}', plane.limit_words) : words.note);
    draw(plane, values, words);
    tabulate(plane, values, words);
    state(plane, values, average, words);
  }

  // What is saved of a page during a preview has no way back.
  var panels = Array.from(document.querySelectorAll('details.levels'));
  if (document.querySelector('.plane.preview') !== null) {
    var saved = document.createElement('p');
    saved.className = 'message';
    saved.textContent = panels[0].getAttribute('data-saved');
    document.querySelector('main').prepend(saved);
    panels.forEach(function (panel) { panel.hidden = true; });
    return;
  }

  panels.forEach(function (panel) {
    var room = panel.closest('.space'), planes = null;
    var sliders = Array.from(panel.querySelectorAll('input[data-group]'));
    var maintenance = panel.querySelector('input[data-now]'), now = Number(maintenance.getAttribute('data-now'));
    var levels = sliders.map(function () { return 1; }), kept = now;  // a slider holds whole steps only
    var decimal = panel.getAttribute('data-decimal');
    var words = {
      preview: panel.getAttribute('data-preview'), stays: panel.getAttribute('data-stays'), note: panel.getAttribute('data-note'),
      missed: panel.getAttribute('data-missed'),
      number: function (text) { return text.replace('.', decimal); }
    };
    function told(slider, text) { slider.parentNode.querySelector('output').textContent = words.number(text); }
    function factor_words(factor) { return (maintenance.hasAttribute('data-is-common') ? '' : '× ') + Number(factor.toFixed(3)); }
    function percent(level) { return Number((100 * level).toFixed(3)); }

    // The line of the project that makes it a verdict.
    function tell(is_moved) {
      var dims = '', is_common = maintenance.hasAttribute('data-is-common'), nameless = false;
      sliders.forEach(function (slider, i) {
        if (levels[i] === 1) return;
        var name = slider.getAttribute('data-group');
        if (name === '') nameless = true;
        else dims += String.fromCharCode(60) + 'dim group="' + name + '" level="' + levels[i] + '"/>';
      });
      var text = dims === '' ? '' : String.fromCharCode(60) + 'scene id="preview">' + dims + String.fromCharCode(60) + '/scene>';
      if (kept !== now) {
        text += (text === '' ? '' : ', ') + (is_common ? 'maintenance-factor="' + kept + '"' : 'maintenance-factor × ' + kept);
      }
      var line = panel.querySelector('[role=status]');
      line.hidden = text === '';
      line.querySelector('code').textContent = text;
      panel.querySelector('.nameless').hidden = !nameless;
      if (!is_moved) line.hidden = true;
    }
    function update() {
      take_back();
      if (active !== null) {
        if (active !== settle) active();
      }
      active = settle;
      var factor = now > 0 ? kept / now : 1;
      var is_moved = levels.some(function (level) { return level !== 1; }) || factor !== 1;
      sliders.forEach(function (slider, i) { told(slider, percent(levels[i]) + ' %'); });
      told(maintenance, factor_words(kept));
      tell(is_moved);
      if (!is_moved) return;
      if (planes === null) planes = Array.from(room.querySelectorAll('[data-light]')).map(read_plane);
      planes.forEach(function (plane) { show(plane, levels, factor, words); });
      room.querySelectorAll('article.plane').forEach(function (article) {
        if (article.classList.contains('preview')) return;
        note(article, article.querySelector('details.card > div'), words.stays);
        article.classList.remove('preview');
      });
    }
    function settle() {
      levels = levels.map(function () { return 1; });
      sliders.forEach(function (slider) {
        slider.value = 100;
        told(slider, '100 %');
      });
      maintenance.value = kept = now;
      told(maintenance, factor_words(now));
      tell(false);
    }
    sliders.forEach(function (slider, i) {
      slider.addEventListener('input', function () {
        levels[i] = Math.round(slider.value) / 100;
        update();
      });
    });
    maintenance.addEventListener('input', function () {
      kept = Number(maintenance.value);
      update();
    });
    panel.querySelectorAll('button[data-levels]').forEach(function (button) {
      button.addEventListener('click', function () {
        levels = numbers(button.getAttribute('data-levels'));
        sliders.forEach(function (slider, i) { slider.value = 100 * levels[i]; });
        update();
      });
    });
    panel.querySelector('form').addEventListener('reset', function (event) {
      event.preventDefault();
      settle();
      update();
    });
    panel.hidden = false;
  });
  // A preview is never printed.
  addEventListener('beforeprint', function () {
    if (active === null) return;
    take_back();
    active();
    active = null;
  });
})();
