/// Asks for the token of a server that needs one, since a browser does not tell why a WebSocket was refused.
import { h, labelled } from './dom.ts';

/// The token in an address that was copied whole, or the text itself.
export function tokenIn(text: string): string {
  return /[?&]token=([^&#\s]+)/.exec(text)?.[1] ?? text.trim();
}

export class TokenForm {
  private readonly why = h('p', { role: 'alert' });
  private readonly field = h('input', { autocomplete: 'off', spellcheck: 'false', class: 'wide' });
  readonly element = h('section', { class: 'token', 'aria-labelledby': 'token-title', hidden: true },
    h('h2', { id: 'token-title' }, 'This server asks for a token'),
    this.why,
    h('p', {}, 'It is part of the address that pongsim printed at its start: open that address, or enter it here.'),
    h('form', { onsubmit: (event: Event) => this.enter(event) },
      labelled('Address or token', this.field), h('button', { type: 'submit' }, 'Connect')));

  /// Shows the form if the server refuses this page for want of the right token.
  /// @param query Of the page's requests: "?token=...", or empty.
  async check(query: string): Promise<void> {
    // the token is needed for files of the world, too, and there the answer can be read
    const answer = await fetch(`assets/${query}`).catch(() => null);
    if (answer?.status !== 401) return;
    this.why.textContent = await answer.text();
    this.element.hidden = false;
  }

  hide(): void {
    this.element.hidden = true;
  }

  private enter(event: Event): void {
    event.preventDefault();
    const address = new URL(location.href);
    address.searchParams.set('token', tokenIn(this.field.value));
    location.assign(address);
  }
}
