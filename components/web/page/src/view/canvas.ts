/// Fills `parent` with a canvas that keys reach.
export function fillWithCanvas(parent: HTMLElement, canvas: HTMLCanvasElement, name: string): void {
  canvas.style.cssText = 'display:block;width:100%;height:100%';
  canvas.tabIndex = 0;
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', `${name}: Shift and arrows rotate, plus and minus zoom`);
  parent.append(canvas);
}
