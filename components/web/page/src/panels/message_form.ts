/// A form for any message type, with one input per field.
import type { DescEnum, DescField, DescMessage } from '@bufbuild/protobuf';
import { h, iconButton, numberField } from '../app/dom.ts';
import { scalarKind } from '../connection/fields.ts';
import type { Message } from '../connection/types.ts';

interface FormField {
  element: HTMLElement;
  /// @return The entered value; undefined if the input is empty.
  /// @throws Error with the field's name if the text is not a value of its type.
  value(): unknown;
}

/// @return The form; `value` returns the fields that are not empty.
export function messageForm(type: DescMessage): { element: HTMLElement; value(): Message } {
  const inputs = type.fields.map((field) => ({ field, input: fieldInput(field) }));
  const element = h('div', { class: 'form' }, ...inputs.map(({ input }) => input.element));
  const value = (): Message => {
    const message: Message = {};
    for (const { field, input } of inputs) {
      const filled = input.value();
      if (filled === undefined) continue;
      if (field.oneof) message[field.oneof.localName] = { case: field.localName, value: filled };
      else message[field.localName] = filled;
    }
    return message;
  };
  return { element, value };
}

function fieldInput(field: DescField): FormField {
  if (field.fieldKind === 'list') return listInput(field);
  if (field.fieldKind === 'map') {
    return { element: h('p', { class: 'hint' }, `${field.name}: maps can't be filled in here`), value: () => undefined };
  }
  if (field.message) return messageInput(field.name, field.message);
  if (field.enum) return named(field.name, enumInput(field.enum));
  return named(field.name, scalarInput(field));
}

function named(name: string, { element, value }: FormField): FormField {
  return { element: h('label', { class: 'field' }, name, element), value };
}

function enumInput(type: DescEnum): FormField {
  const select = h('select', {}, ...type.values.map(({ name, number }) => h('option', { value: number }, name)));
  return { element: select, value: () => (Number(select.value) === 0 ? undefined : Number(select.value)) };
}

function scalarInput(field: DescField): FormField {
  const kind = scalarKind(field.scalar!);
  if (kind === 'bool') {
    const box = h('input', { type: 'checkbox' });
    return { element: box, value: () => box.checked || undefined };
  }
  if (kind === 'number') {
    const input = numberField(0);
    input.value = '';
    input.placeholder = '0';
    return { element: input, value: () => numberOf(field, input.value) };
  }
  const input = h('input', { placeholder: kind === 'bytes' ? 'text, as bytes' : '' });
  const value = (): unknown => {
    if (input.value === '') return undefined;
    return kind === 'bytes' ? new TextEncoder().encode(input.value) : input.value;
  };
  return { element: input, value };
}

/// @throws Error with the field's name if the text is not a number of its type.
export function numberOf(field: Pick<DescField, 'name' | 'scalar'>, text: string): number | bigint | undefined {
  if (text.trim() === '') return undefined;
  const value = Number(text);
  if (!Number.isFinite(value)) throw new Error(`${field.name}: '${text}' is not a number`);
  // ScalarType: DOUBLE, FLOAT
  if (field.scalar === 1 || field.scalar === 2) return value;
  if (!Number.isInteger(value)) throw new Error(`${field.name}: '${text}' is not a whole number`);
  // INT64, UINT64, FIXED64, SFIXED64, SINT64
  return [3, 4, 6, 16, 18].includes(field.scalar!) ? BigInt(text) : value;
}

/// The form of a nested message is created when it is opened, because types may be recursive.
function messageInput(name: string, type: DescMessage): FormField {
  let form: ReturnType<typeof messageForm> | null = null;
  const details = h('details', {}, h('summary', {}, name));
  details.addEventListener('toggle', () => {
    if (form || !details.open) return;
    form = messageForm(type);
    details.append(form.element);
  });
  const value = (): unknown => {
    if (!form || !details.open) return undefined;
    const filled = form.value();
    return Object.keys(filled).length > 0 ? filled : undefined;
  };
  return { element: details, value };
}

function listInput(field: DescField & { fieldKind: 'list' }): FormField {
  const inputs: FormField[] = [];
  const items = h('div', {});
  const add = iconButton('+', `Add to ${field.name}`, () => {
    const input = field.message ? messageInput(`[${inputs.length}]`, field.message)
      : named(`[${inputs.length}]`, field.enum ? enumInput(field.enum) : scalarInput(field));
    inputs.push(input);
    items.append(input.element);
  });
  const element = h('div', { class: 'list' }, h('span', {}, field.name), add, items);
  const none = field.message ? {} : field.scalar === 9 ? '' : 0;
  return { element, value: () => (inputs.length > 0 ? inputs.map((input) => input.value() ?? none) : undefined) };
}
