// Keys of the page. Those of a focused control stay its own.

const TEXT = 'input:not([type=range]), textarea';

/** `bindings` maps a key to what it does; a binding that returns false leaves the event alone. */
export function listen(bindings) {
  window.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const focus = document.activeElement;
    if (focus?.matches?.(TEXT)) return;
    if (focus?.matches?.('select') && event.key !== '?') return;
    // Space on a focused button presses that button.
    if (event.key === ' ' && focus?.matches?.('button, a, summary')) return;
    if (document.querySelector('dialog[open]') && event.key !== '?') return;
    const does = bindings.get(event.key) ?? bindings.get(event.key.toLowerCase());
    if (does && does(event) !== false) event.preventDefault();
  });
}
