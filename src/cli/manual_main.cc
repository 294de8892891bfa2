// Writes the manual's pages while pongsim is built: pongsim-manual FOLDER.
#include "cli/cli.hh"

int main(int argc, char** argv) { return argc == 2 && pongsim_write_manual(argv[1]) ? 0 : 1; }
