/// Questions to the user.
import { h } from './dom.ts';

/// Asks whether to do something; Escape and the other button are no.
/// @param action Text of the button that does it: "Remove".
export function isSure(title: string, text: string, action: string): Promise<boolean> {
  const dialog = h('dialog', { class: 'question', role: 'alertdialog', 'aria-labelledby': 'question-title', 'aria-describedby': 'question-text' },
    h('h2', { id: 'question-title' }, title),
    h('p', { id: 'question-text' }, text),
    h('form', { method: 'dialog', class: 'row' },
      h('button', { value: 'yes' }, action), h('button', { value: 'no', autofocus: true }, 'Cancel')));
  document.body.append(dialog);
  dialog.showModal();
  return new Promise((resolve) => dialog.addEventListener('close', () => {
    dialog.remove();
    resolve(dialog.returnValue === 'yes');
  }));
}
