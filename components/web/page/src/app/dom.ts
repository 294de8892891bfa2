/// Creates HTML elements, each with attributes and children in one expression.

type Child = Node | string | null | undefined | false;
type Attributes = Record<string, string | number | boolean | ((event: never) => void) | undefined>;

/// h('button', { class: 'x', onclick: f, disabled: true }, 'text'). Attributes named "on..." are event listeners; true
/// sets an attribute without a value; false and undefined are ignored.
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Attributes = {}, ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(name.slice(2), value as EventListener);
    else if (value === true) element.setAttribute(name, '');
    else if (value !== false && value !== undefined) element.setAttribute(name, String(value));
  }
  for (const child of children) if (child) element.append(child);
  return element;
}

/// Makes these the children of an element. Children that are already in place are not moved, which would lose focus or
/// a click in progress.
export function setChildren(element: Element, children: readonly Element[]): void {
  const wanted = new Set(children);
  for (const child of [...element.children]) if (!wanted.has(child)) child.remove();
  children.forEach((child, i) => {
    const present = element.children[i];
    if (present !== child) element.insertBefore(child, present ?? null);
  });
}

let nextId = 1;

/// A field with a label before it.
export function labelled(text: string, field: HTMLElement, more: Attributes = {}): HTMLElement {
  if (!field.id) field.id = `field-${nextId++}`;
  return h('div', { class: 'field', ...more }, h('label', { for: field.id }, text), field);
}

export function numberField(value: number, more: Attributes = {}): HTMLInputElement {
  const field = h('input', { type: 'number', step: 'any', ...more });
  field.value = String(value);
  return field;
}

/// Calls `act` when a value has been entered. Until it is edited again, the field shows what is true, and Ctrl+Z is the
/// page's and not the field's.
export function onEntered(field: HTMLInputElement, act: () => void): void {
  field.addEventListener('input', () => delete field.dataset.entered);
  field.addEventListener('blur', () => delete field.dataset.entered);
  field.addEventListener('change', () => {
    field.dataset.entered = '';
    act();
  });
}

/// Whether the user is typing a value into the field, which must not be overwritten.
export function isEditing(field: HTMLInputElement): boolean {
  return field === document.activeElement && field.dataset.entered === undefined;
}

/// Sets the options of a list. The selected one stays selected if it is still an option.
export function setChoices(select: HTMLSelectElement, choices: readonly string[], none?: string): void {
  const before = select.value;
  const values = none === undefined ? choices : ['', ...choices];
  if (values.length === select.options.length && values.every((value, i) => select.options[i]!.value === value)) return;
  select.replaceChildren(...values.map((value) => h('option', { value }, value === '' ? none! : value)));
  select.value = values.includes(before) ? before : (values[0] ?? '');
}

/// A button with an icon or a character; `name` is its tooltip and accessible name.
export function iconButton(icon: Node | string, name: string, act: () => void, more: Attributes = {}): HTMLButtonElement {
  return h('button', { type: 'button', class: 'icon', title: name, 'aria-label': name, onclick: act, ...more }, icon);
}

/// A number with up to four significant decimals.
export function shortNumber(value: number): string {
  if (!Number.isFinite(value)) return String(value);
  const text = Math.abs(value) >= 1e6 || (value !== 0 && Math.abs(value) < 1e-4) ? value.toExponential(3) : value.toFixed(4);
  return text.includes('e') ? text : text.replace(/\.?0+$/, '') === '-0' ? '0' : text.replace(/\.?0+$/, '');
}

/// Saves bytes as a file, by a click on a temporary link.
export function download(name: string, content: Blob): void {
  const address = URL.createObjectURL(content);
  h('a', { href: address, download: name }).click();
  // revoked later, because the browser may read the address after the click
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
