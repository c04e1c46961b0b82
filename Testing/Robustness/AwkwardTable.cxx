// SPDX-License-Identifier: BSD-3-Clause
// The table of awkward meshes: a row a mesh, a column a filter.
//   awkward-meshes                 all meshes, every filter in every mode
//   awkward-meshes --quick         those of every run of the tests, each in every 23rd mode
//   awkward-meshes --mesh NAME     one mesh, with a line for each mode
//   awkward-meshes --write FOLDER  the meshes as files, for programs and scripts
#include "AwkwardChecks.h"
#include "ChildProcess.h"

#include "TimeLimit.h"

#include "vtkAlgorithm.h"
#include "vtkOutputWindow.h"
#include "vtkXMLDataObjectWriter.h"
#include "vtkXMLMultiBlockDataWriter.h"
#include "vtkXMLWriter.h"

#include <chrono>
#include <iostream>
#include <map>
#include <string>

using namespace robustness;

namespace
{

constexpr double secondsOfACheck = 120.0;

struct Row
{
  std::map<std::string, std::string> Cells; ///< marks by filter
  int Asked = 0;
  int Lost = 0;
};

const char* MarkOf(Verdict verdict)
{
  switch (verdict)
  {
    case Verdict::Right:
      return "=";
    case Verdict::Sound:
      return ".";
    case Verdict::Said:
      return "m";
    default:
      return "X";
  }
}

/// Which checks a mesh gets: every one, or every so many, from another one for each mesh.
struct Share
{
  std::size_t First = 0;
  std::size_t Step = 1;
};

/// In a process of its own: a line before each check and one behind it.
void AskAll(const AwkwardMesh& mesh, const Share& share, const Tell& tell)
{
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  tell({ "begin", "chain" });
  alarm(static_cast<unsigned>(TimeLimit(secondsOfACheck)));
  const Scene scene(mesh);
  for (std::size_t k = share.First; k < AllChecks().size(); k += share.Step)
  {
    const Check& check = AllChecks()[k];
    tell({ "begin", check.Filter + " " + check.Mode });
    alarm(static_cast<unsigned>(TimeLimit(secondsOfACheck)));
    const auto begin = std::chrono::steady_clock::now();
    const Finding found = check.Ask(scene);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    tell({ "end", check.Filter, check.Mode, MarkOf(found.Kind), std::to_string(seconds), found.Text });
  }
}

Row AskInProcess(const AwkwardMesh& mesh, const Share& share, bool verbose)
{
  Row row;
  std::string running;
  const ChildEnd end = RunInChild([&](const Tell& tell) { AskAll(mesh, share, tell); });
  for (const Line& line : end.Lines)
  {
    if (line[0] == "begin")
    {
      running = line[1];
      continue;
    }
    row.Cells[line[1]] += line[3];
    ++row.Asked;
    const bool lost = line[3] == "X";
    row.Lost += lost;
    if (lost || verbose)
    {
      std::cout << "  " << mesh.Name << ", " << line[1] << " " << line[2] << ": " << (lost ? "LOST " : "") << line[3] << " "
                << line[4] << " s " << (line.size() > 5 ? line[5] : "") << "\n";
    }
  }
  if (end.Crashed())
  {
    ++row.Lost;
    std::cout << "  " << mesh.Name << ", " << running << ": LOST " << end.Why() << "\n";
  }
  return row;
}

int WriteAll(const std::string& folder)
{
  for (const AwkwardMesh& mesh : AwkwardMeshes(Run::Quick))
  {
    if (mesh.Name == "degenerate-cells" || mesh.Name == "no-area")
    {
      continue; // VTK's writer ends the process on polygons of fewer than three corners
    }
    vtkSmartPointer<vtkXMLWriter> writer;
    if (mesh.Data->IsA("vtkMultiBlockDataSet"))
    {
      writer = vtkSmartPointer<vtkXMLMultiBlockDataWriter>::New();
    }
    else
    {
      writer.TakeReference(vtkXMLDataObjectWriter::NewWriter(mesh.Data->GetDataObjectType()));
    }
    const std::string name = folder + "/" + mesh.Name + "." + writer->GetDefaultFileExtension();
    writer->SetInputDataObject(mesh.Data);
    writer->SetFileName(name.c_str());
    if (!writer->Write())
    {
      std::cerr << name << " cannot be written\n";
      return 1;
    }
    std::cout << name << "\t" << (mesh.Casts() ? "casts" : mesh.Refusal.empty() ? "empty" : mesh.Refusal) << "\n";
  }
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  const std::string option = argc > 1 ? argv[1] : "";
  const std::string value = argc > 2 ? argv[2] : "";
  if (option == "--write" && !value.empty())
  {
    return WriteAll(value);
  }
  if (!(option.empty() || option == "--quick" || (option == "--mesh" && !value.empty())))
  {
    std::cerr << "awkward-meshes [--quick | --mesh NAME | --write FOLDER]\n";
    return 2;
  }
  const std::vector<AwkwardMesh> meshes = AwkwardMeshes(option == "--quick" ? Run::Quick : Run::Long, value);
  if (meshes.empty())
  {
    std::cerr << "there is no mesh " << value << "\n";
    return 2;
  }
  std::map<std::string, Row> rows;
  int asked = 0;
  int lost = 0;
  constexpr std::size_t quickStep = 23;
  for (std::size_t k = 0; k < meshes.size(); ++k)
  {
    const AwkwardMesh& mesh = meshes[k];
    const Share share = option == "--quick" ? Share{ k % quickStep, quickStep } : Share();
    rows[mesh.Name] = AskInProcess(mesh, share, option == "--mesh");
    asked += rows[mesh.Name].Asked;
    lost += rows[mesh.Name].Lost;
  }
  std::vector<std::string> filters;
  for (const Check& check : AllChecks())
  {
    if (filters.empty() || filters.back() != check.Filter)
    {
      filters.push_back(check.Filter);
    }
  }
  std::cout << "A sign a mode: = as the truth, . finite and in range, m a message where one is due, X lost\n\n| mesh |";
  for (const std::string& filter : filters)
  {
    std::cout << " " << filter << " |";
  }
  std::cout << "\n|---|";
  for (std::size_t k = 0; k < filters.size(); ++k)
  {
    std::cout << "---|";
  }
  for (const AwkwardMesh& mesh : meshes)
  {
    std::cout << "\n| " << mesh.Name << " |";
    for (const std::string& filter : filters)
    {
      std::cout << " " << rows[mesh.Name].Cells[filter] << " |";
    }
  }
  std::cout << "\n\nmeshes: " << meshes.size() << ", asked: " << asked << ", lost: " << lost << "\n";
  return lost > 0 ? 1 : 0;
}
