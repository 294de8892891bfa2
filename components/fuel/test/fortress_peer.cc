// Does with a Fuel address what Fortress does, by Debian's own library: fortress_peer find|download|file ADDRESS.
#include <ignition/fuel_tools/ClientConfig.hh>
#include <ignition/fuel_tools/FuelClient.hh>
#include <ignition/fuel_tools/Interface.hh>
#include <iostream>
#include <string>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  namespace ft = ignition::fuel_tools;
  const std::string action = argv[1];
  // both names of the server, as in releases after Debian's
  ft::ClientConfig config;
  for (const char* url : {"https://fuel.gazebosim.org", "https://fuel.ignitionrobotics.org"}) {
    ft::ServerConfig server;
    server.SetUrl(ignition::common::URI(url));
    config.AddServer(server);
  }
  ft::FuelClient client(config);
  const ignition::common::URI uri(argv[2]);
  std::string path;
  if (action == "find") {
    if (!client.CachedModel(uri, path) && !client.CachedWorld(uri, path)) return 1;
  } else if (action == "file") {
    if (!client.CachedModelFile(uri, path)) return 1;
  } else if (action == "download") {
    if (!client.DownloadModel(uri, path) && !client.DownloadWorld(uri, path)) return 1;
  } else {
    path = ft::fetchResourceWithClient(argv[2], client);
  }
  std::cout << path << "\n";
  return path.empty() ? 1 : 0;
}
