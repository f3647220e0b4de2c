// Curves over time on a small canvas.

const mostSamples = 2000;

class Plot {
  constructor(canvas) {
    this.canvas = canvas;
    this.clear();
  }

  clear() {
    this.times = [];
    this.values = [];
    this.draw('');
  }

  // Every other sample is left out when there are too many, so that all of the time is seen.
  add(time, value) {
    this.times.push(time);
    this.values.push(value);
    if (this.times.length <= mostSamples) return;
    const keep = (_, i) => i % 2 === 0;
    this.times = this.times.filter(keep);
    this.values = this.values.filter(keep);
  }

  draw(unit) {
    const {canvas, times, values} = this;
    const box = canvas.getBoundingClientRect();
    canvas.width = Math.max(1, Math.round(box.width * window.devicePixelRatio));
    canvas.height = Math.max(1, Math.round(box.height * window.devicePixelRatio));
    const pen = canvas.getContext('2d');
    const style = getComputedStyle(canvas);
    const size = 11 * window.devicePixelRatio;
    pen.font = `${size}px sans-serif`;
    pen.fillStyle = style.color;
    pen.strokeStyle = style.getPropertyValue('--mark') || style.color;
    if (times.length < 2) return;
    let [low, high] = [Math.min(...values), Math.max(...values)];
    if (!(high - low > 1e-9 * Math.max(1, Math.abs(high)))) [low, high] = [low - 0.5, high + 0.5];
    const [begin, end] = [times[0], times[times.length - 1]];
    pen.lineWidth = 1.5 * window.devicePixelRatio;
    pen.beginPath();
    times.forEach((time, i) => {
      const x = (time - begin) / (end - begin) * canvas.width;
      const y = canvas.height - size * 1.3 -
          (values[i] - low) / (high - low) * (canvas.height - 2.6 * size);
      if (i === 0) {
        pen.moveTo(x, y);
      } else {
        pen.lineTo(x, y);
      }
    });
    pen.stroke();
    pen.fillText(`${numberText(high)} ${unit}`, 2, size);
    pen.fillText(`${numberText(low)} ${unit}`, 2, canvas.height - 2);
    const words = `${numberText(end)} s`;
    pen.fillText(words, canvas.width - pen.measureText(words).width - 2, canvas.height - 2);
  }
}
