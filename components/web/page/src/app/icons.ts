/// Icons of buttons as SVG paths, because not all machines have fonts with such symbols.

const kPaths = {
  play: 'M7 4v16l13-8z',
  pause: 'M6 4h4v16H6zM14 4h4v16h-4z',
  step: 'M5 4v16l10-8zM17 4h3v16h-3z',
  reset: 'M12 5V1L6 6l6 5V7a5 5 0 1 1-5 5H5a7 7 0 1 0 7-7z',
  select: 'M5 2l14 11-6 1 4 7-3 1-4-7-5 4z',
  move: 'M12 1l4 4h-3v6h6V8l4 4-4 4v-3h-6v6h3l-4 4-4-4h3v-6H5v3l-4-4 4-4v3h6V5H8z',
  tabs: 'M3 4h8v4h10v12H3zM5 10v8h14v-8zM13 4h8v2h-8z',
  turn: 'M12 4a8 8 0 1 0 8 8h-2.5A5.5 5.5 0 1 1 12 6.500V10l6-5-6-5z',
  ruler: 'M2 15.500 15.500 2 22 8.500 8.500 22zM5 15.500 8.500 19 19 8.500 17.500 7 15.800 8.700 14.700 7.600 16.400 5.900 15.500 5 13 7.500 14.800 9.300 13.700 10.400 11.900 8.600 10.400 10.100 12.200 11.900 11.100 13 9.300 11.200 7.800 12.700 9.600 14.500 8.500 15.600 6.700 13.800z',
  camera: 'M4 6h4l2-3h4l2 3h4a2 2 0 0 1 2 2v10a2 2 0 0 1-2 2H4a2 2 0 0 1-2-2V8a2 2 0 0 1 2-2zM12 9a4 4 0 1 0 0 8 4 4 0 0 0 0-8z',
  film: 'M3 6h12a1 1 0 0 1 1 1v4l5-4v10l-5-4v4a1 1 0 0 1-1 1H3a1 1 0 0 1-1-1V7a1 1 0 0 1 1-1z',
  theme: 'M12 2a10 10 0 1 0 0 20 10 10 0 0 0 0-20zM12 4.500v15a7.500 7.500 0 0 0 0-15z',
};

export type Icon = keyof typeof kPaths;

export function icon(name: Icon): SVGSVGElement {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  for (const [key, value] of Object.entries({ viewBox: '0 0 24 24', width: '18', height: '18', 'aria-hidden': 'true', class: 'svg-icon' })) {
    svg.setAttribute(key, value);
  }
  const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  path.setAttribute('d', kPaths[name]);
  path.setAttribute('fill', 'currentColor');
  path.setAttribute('fill-rule', 'evenodd');
  svg.append(path);
  return svg;
}
