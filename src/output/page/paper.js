// Colours of the light and the dark theme, and texts on a canvas that do not overlap.
// SPDX-License-Identifier: GPL-3.0-or-later

const dark = matchMedia("(prefers-color-scheme: dark)");
const themeListeners = [];

/** A colour of the style sheet, as #rrggbb. */
const tint = (name) => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();

/** Take a theme, light or dark; without a name the theme of the system. */
function setTheme(name) {
  document.documentElement.dataset.theme = name || (dark.matches ? "dark" : "light");
  for (const listen of themeListeners) listen();
}

const SIDES = [[1, 0], [-1, 0], [0, -1], [0, 1], [1, -1], [1, 1], [-1, -1], [-1, 1]];
const CORNERS = [[1, -1], [-1, -1], [1, 1], [-1, 1], [0, -1], [0, 1], [1, 0], [-1, 0]];

/** Texts that are placed one after the other, none over another. */
class Labels {
  constructor(context, width, height) {
    Object.assign(this, {context, width, height, taken: [], written: []});
    context.font = '12px "DejaVu Sans", Verdana, sans-serif';
    context.textBaseline = "middle";
    context.lineJoin = "round";
  }

  free([x0, y0, x1, y1]) {
    return x0 >= 0 && y0 >= 0 && x1 <= this.width && y1 <= this.height &&
      !this.taken.some(([u0, v0, u1, v1]) => x0 < u1 && u0 < x1 && y0 < v1 && v0 < y1);
  }

  /** Keep texts off a disk. */
  avoid(x, y, radius) {
    this.taken.push([x - radius, y - radius, x + radius, y + radius]);
  }

  write(text, box, strong) {
    const c = this.context;
    c.textAlign = "left";
    c.lineWidth = 4;
    c.strokeStyle = c.fillStyle = tint("paper");
    c.globalAlpha = 0.6;
    c.fillRect(box[0] - 1, box[1] + 1, box[2] - box[0] + 2, box[3] - box[1] - 2);
    c.globalAlpha = 1;
    c.fillStyle = tint(strong ? "ink" : "soft");
    c.strokeText(text, box[0], (box[1] + box[3]) / 2);
    c.fillText(text, box[0], (box[1] + box[3]) / 2);
    this.taken.push(box);
    this.written.push([text, box]);
  }

  /** Write beside a point, at the first of eight places that is free; false if none is. */
  beside(text, x, y, off, strong, sides = SIDES) {
    const width = this.context.measureText(text).width, high = 14;
    for (const [u, v] of sides) {
      const left = u > 0 ? x + off : u < 0 ? x - off - width : x - width / 2;
      const top = v > 0 ? y + off - 2 : v < 0 ? y - off - high + 2 : y - high / 2;
      const box = [left, top, left + width, top + high];
      if (!this.free(box)) continue;
      this.write(text, box, strong);
      return true;
    }
    return false;
  }

  /** Write around a place, which is moved into the canvas, unless another text is there. */
  at(text, x, y) {
    const half = this.context.measureText(text).width / 2 + 1;
    const u = Math.min(Math.max(x, half), this.width - half), v = Math.min(Math.max(y, 8), this.height - 8);
    const box = [u - half, v - 7, u + half, v + 7];
    if (this.free(box)) this.write(text, box, true);
  }
}
