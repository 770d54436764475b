// Mouse, touch and wheel on the 3D view: one pointer turns, two pointers (or right button, or shift) shift and zoom.

const CLICK_PIXELS = 5;

export class Gestures {
  /**
   * @param {HTMLElement} element
   * @param {{turn, shift, zoom, click, reset}} does what the gestures mean, in pixels and factors
   */
  constructor(element, does) {
    this.element = element;
    this.does = does;
    this.pointers = new Map();
    this.travelled = 0;
    element.addEventListener('pointerdown', (event) => this.down(event));
    element.addEventListener('pointermove', (event) => this.move(event));
    for (const end of ['pointerup', 'pointercancel']) element.addEventListener(end, (event) => this.up(event));
    element.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    element.addEventListener('dblclick', () => does.reset());
    element.addEventListener('contextmenu', (event) => event.preventDefault());
  }

  down(event) {
    this.element.setPointerCapture(event.pointerId);
    if (this.pointers.size === 0) this.travelled = 0;
    this.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  }

  move(event) {
    const last = this.pointers.get(event.pointerId);
    if (!last) return;
    const before = this.spread();
    const dx = event.clientX - last.x;
    const dy = event.clientY - last.y;
    this.travelled += Math.hypot(dx, dy);
    this.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (this.pointers.size === 2) {
      const after = this.spread();
      if (before > 0 && after > 0) this.does.zoom(after / before);
      this.does.shift(dx / 2, dy / 2);
    } else if (event.buttons & 2 || event.buttons & 4 || event.shiftKey) {
      this.does.shift(dx, dy);
    } else {
      this.does.turn(dx, dy);
    }
  }

  up(event) {
    const known = this.pointers.delete(event.pointerId);
    if (known && event.type === 'pointerup' && this.travelled < CLICK_PIXELS && event.button === 0) {
      this.does.click(event.clientX, event.clientY);
    }
  }

  wheel(event) {
    event.preventDefault();
    const pixels = event.deltaMode === 1 ? event.deltaY * 16 : event.deltaY;
    this.does.zoom(Math.exp(-pixels * 0.0015));
  }

  spread() {
    if (this.pointers.size !== 2) return 0;
    const [a, b] = [...this.pointers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  }
}
