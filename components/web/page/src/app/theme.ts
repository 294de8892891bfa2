/// The colour scheme, dark or light: that of the system, until the user chooses.

export type Theme = 'dark' | 'light';

const kKey = 'pongsim-theme';

export function currentTheme(): Theme {
  const chosen = document.documentElement.dataset.theme ?? stored();
  if (chosen === 'dark' || chosen === 'light') return chosen;
  return matchMedia('(prefers-color-scheme: light)').matches ? 'light' : 'dark';
}

export function setTheme(theme: Theme): void {
  document.documentElement.dataset.theme = theme;
  try {
    localStorage.setItem(kKey, theme);
  } catch {
    // the browser does not allow storage
  }
}

function stored(): string | null {
  try {
    return localStorage.getItem(kKey);
  } catch {
    return null;
  }
}
