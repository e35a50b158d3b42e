#include "viz/vtk/tree_file.h"

#include <vtkBase64Utilities.h>
#include <vtkDataAssembly.h>
#include <vtkIndent.h>
#include <vtkNew.h>

#include <map>
#include <sstream>

#include "viz/vtk/block.h"
#include "viz/vtk/xml.h"

namespace gnomon::viz {
namespace {

std::string attribute(const std::string& name, const std::string& value) {
  std::string text = " ";
  return text.append(name).append("=\"").append(xml_escaped(value)).append("\"");
}

std::string attribute(const std::string& name, std::size_t value) {
  return attribute(name, std::to_string(value));
}

std::string vtk_file(const std::string& type, const std::string& body, const Fields& fields) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- gnomon " GNOMON_VERSION " -->\n<VTKFile" +
         attribute("type", type) + " version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt32\">\n  <" + type +
         ">\n" + body + "  </" + type + ">\n" + field_data_xml(fields) + "</VTKFile>\n";
}

/// The leaves below one node. They share the first `depth` parts of their paths; siblings come one after the other.
void write_children(std::ostream& out, std::span<const TreeLeaf> leaves, std::size_t depth) {
  const std::string indent(2 * depth + 4, ' ');
  std::size_t index = 0;
  for (std::size_t first = 0, last = 0; first < leaves.size(); first = last, ++index) {
    const std::vector<std::string>& path = leaves[first].path;
    while (last < leaves.size() && leaves[last].path[depth] == path[depth]) ++last;
    const std::string name = attribute("index", index) + attribute("name", path[depth]);
    if (path.size() == depth + 1) {
      out << indent << "<DataSet" << name << attribute("file", leaves[first].file) << "/>\n";
      last = first + 1;
    } else {
      out << indent << "<Block" << name << ">\n";
      write_children(out, leaves.subspan(first, last - first), depth + 1);
      out << indent << "</Block>\n";
    }
  }
}

/// The node of a path, made if it is not there.
int assembly_node(vtkDataAssembly& assembly, std::map<std::vector<std::string>, int>& nodes,
                  const std::vector<std::string>& path) {
  if (path.empty()) return vtkDataAssembly::GetRootNode();
  const auto known = nodes.find(path);
  if (known != nodes.end()) return known->second;
  const int parent = assembly_node(assembly, nodes, {path.begin(), path.end() - 1});
  const int node = assembly.AddNode(vtkDataAssembly::MakeValidNodeName(path.back().c_str()).c_str(), parent);
  assembly.SetAttribute(node, "label", path.back().c_str());
  return nodes[path] = node;
}

std::string assembly_text(std::span<const TreeLeaf> leaves) {
  vtkNew<vtkDataAssembly> assembly;
  std::map<std::vector<std::string>, int> nodes;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    assembly->AddDataSetIndex(assembly_node(*assembly, nodes, leaves[i].path), static_cast<unsigned int>(i));
  }
  const std::string xml = assembly->SerializeToXML(vtkIndent());
  std::string encoded(2 * xml.size() + 4, '\0');
  encoded.resize(vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(xml.data()), xml.size(),
                                            reinterpret_cast<unsigned char*>(encoded.data())));
  return encoded;
}

}  // namespace

std::string multiblock_xml(std::span<const TreeLeaf> leaves, const Fields& fields) {
  std::ostringstream out;
  write_children(out, leaves, 0);
  return vtk_file("vtkMultiBlockDataSet", out.str(), fields);
}

std::string partitioned_xml(std::span<const TreeLeaf> leaves, const Fields& fields) {
  std::ostringstream out;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    out << "    <Partitions" << attribute("index", i) << attribute("name", joined(leaves[i].path))
        << ">\n      <DataSet index=\"0\"" << attribute("file", leaves[i].file) << "/>\n    </Partitions>\n";
  }
  out << "    <DataAssembly encoding=\"base64\">\n      " << assembly_text(leaves) << "\n    </DataAssembly>\n";
  return vtk_file("vtkPartitionedDataSetCollection", out.str(), fields);
}

}  // namespace gnomon::viz
