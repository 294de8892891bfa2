// Writes the manual's pages when pongsim is built: pongsim-manual FOLDER, or the page of an additional package:
// pongsim-manual FOLDER DESCRIPTOR.
#include "cli/cli.hh"

int main(int argc, char** argv) {
  if (argc == 2) return pongsim_write_manual(argv[1]) ? 0 : 1;
  return argc == 3 && pongsim_write_extension_manual(argv[2], argv[1]) ? 0 : 1;
}
