/// The full name of a topic or service: without a slash it begins with one, as in ign-transport.
export function fullTopic(name: string): string {
  return name === '' || name.startsWith('/') ? name : `/${name}`;
}
