// Elements, and numbers as text. Names from files only ever become text nodes.

function element(tag, attributes, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {})) {
    if (name.startsWith('on')) {
      made.addEventListener(name.slice(2), value);
    } else if (name === 'color') {
      paint(made, value);
    } else {
      made.setAttribute(name, value);
    }
  }
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

// The background #rrggbb, and on it black or white text: of both the one with more contrast, which
// is at least 4.5 to 1 (WCAG 2.1, relative luminance).
function paint(made, color) {
  const [r, g, b] = [1, 3, 5].map((at) => {
    const part = parseInt(color.slice(at, at + 2), 16) / 255;
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  });
  made.style.background = color;
  made.style.color = 0.2126 * r + 0.7152 * g + 0.0722 * b > 0.179 ? '#000' : '#fff';
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
