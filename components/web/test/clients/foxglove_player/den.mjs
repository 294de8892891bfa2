// In place of @foxglove/den, which is not in npm's registry: what the player uses of it.

/// A function that calls `call` again only once the promise of the call before has settled.
export function debouncePromise(call) {
  let isRunning = false;
  let isDue = false;
  return function run() {
    if (isRunning) {
      isDue = true;
      return;
    }
    isRunning = true;
    void Promise.resolve(call()).finally(() => {
      isRunning = false;
      if (isDue) {
        isDue = false;
        run();
      }
    });
  };
}

export function filterMap(values, convert) {
  return values.map(convert).filter(Boolean);
}
