// Elements, and numbers as text. Names from files only ever become text nodes.

function element(tag, attributes, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {})) {
    if (name.startsWith('on')) {
      made.addEventListener(name.slice(2), value);
    } else if (name === 'color') {
      made.style.background = value;
    } else {
      made.setAttribute(name, value);
    }
  }
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

function byId(id) {
  return document.getElementById(id);
}

function fill(id, ...children) {
  byId(id).replaceChildren(...children);
}

function swatch(color) {
  return element('span', {class: 'swatch', color});
}

// A number with so many significant digits; those outside 1e-4 .. 1e5 with an exponent.
function numberText(value, digits = 3) {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  return size >= 1e-4 && size < 1e5 ? String(Number(value.toPrecision(digits))) :
                                      value.toExponential(digits - 1);
}

// The direction of a vector in words: the axes of the world that it is nearest to.
function directionWords(v) {
  const parts = [['+x', v.x], ['+y', v.y], ['up', v.z], ['−x', -v.x], ['−y', -v.y], ['down', -v.z]];
  const size = v.length();
  const along = parts.filter(([, part]) => part > 0.38 * size).sort((a, b) => b[1] - a[1]);
  return along.map(([name]) => name).join(' and ');
}
