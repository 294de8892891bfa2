/// The address of a file that is referenced in the file `address`.
export function addressBeside(address: string, name: string): string {
  const clean = name.replaceAll('\\', '/').replace(/^file:\/\//, '');
  const scheme = /^[a-z][a-z0-9+.-]*:\/\//i.exec(address)?.[0] ?? '';
  if (clean.startsWith('/')) return scheme === '' ? clean : address;
  const parts = address.slice(scheme.length).split('/').slice(0, -1);
  for (const part of clean.split('/')) {
    if (part === '.' || part === '') continue;
    if (part === '..' && parts.length > 1) parts.pop();
    else if (part !== '..') parts.push(part);
  }
  return scheme + parts.join('/');
}

/// The extension of a file's name in lower case, such as "dae".
export function endingOf(address: string): string {
  return (/\.([^./]+)$/.exec(address.split(/[?#]/)[0]!)?.[1] ?? '').toLowerCase();
}

/// Possible addresses of a texture that is referenced in a mesh file: relative to it, or, as in Fortress, in the folder
/// for the textures of models.
export function pictureAddresses(mesh: string, name: string): string {
  const places = [name, `../materials/textures/${name}`].map((place) => addressBeside(mesh, place));
  return [...new Set(places)].join('\n');
}
