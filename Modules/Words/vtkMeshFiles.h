// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshFiles
 * @brief Occluders from files of meshes: one block a file, by its name.
 *
 * Formats: vtp, vtk and vtu (of volumes their surface), ply, stl, obj, 3ds, gltf and glb. A file that is broken is an error, said
 * in a sentence, and never a crash: VTK's readers work in a process of their own. Only polygons are taken; point data such as
 * "Normals" and cell data such as "OccluderId" and "Reflectance" come with them. Polygons of fewer than three corners are left out: VTK 9.1
 * ends the process where it is asked for one.
 *
 * Output: vtkMultiBlockDataSet, a vtkPolyData a file, in the order of the files. The name of a block is that of its file without
 * folders and extension, with a number behind it where several files have the same.
 *
 * Memory: that of the meshes, and while a file is read as much again.
 *
 * @sa vtkLabelOccluders vtkLightWords
 */
#ifndef vtkMeshFiles_h
#define vtkMeshFiles_h

#include "ShadowConesWordsModule.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For what was read

#include <string>
#include <vector>

class vtkLabelOccluders;
class vtkMultiBlockDataSet;
class vtkPolyData;

class SHADOWCONESWORDS_EXPORT vtkMeshFiles : public vtkObject
{
public:
  static vtkMeshFiles* New();
  vtkTypeMacro(vtkMeshFiles, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What makes one occluder.
  enum OccludersByType
  {
    Automatic = 0, ///< Component for one file, File for several
    File = 1,      ///< each file is one occluder, with its name
    Component = 2  ///< triangles that share a point
  };

  ///@{
  /**
   * The files to read, in the order in which they are added.
   */
  void AddFileName(const std::string& name);
  void RemoveAllFileNames();                             ///< No file is to be read from here on.
  int GetNumberOfFileNames();                            ///< Number of files to read.
  std::string GetFileName(int index);                    ///< The name of a file as it was added, index from 0.
  ///@}

  ///@{
  /**
   * What makes one occluder: see LabelOccluders(). Default: Automatic.
   */
  vtkSetMacro(OccludersBy, int);
  vtkGetMacro(OccludersBy, int);                                       ///< 0 Automatic, 1 File, 2 Component.
  void SetOccludersByToAutomatic() { this->SetOccludersBy(Automatic); } ///< Component for one file, File for several.
  void SetOccludersByToFile() { this->SetOccludersBy(File); }           ///< Each file is one occluder.
  void SetOccludersByToComponent() { this->SetOccludersBy(Component); } ///< Triangles that share a point are one.
  ///@}

  /**
   * Read all files. @return false, with a sentence of GetError(), at the first one that cannot be read; there is no output then.
   */
  bool Read();
  /// What went wrong in Read(), as a sentence that names the file; empty where nothing did.
  std::string GetError() { return this->Error; }

  /// The meshes that were read, a block a file.
  vtkMultiBlockDataSet* GetOutput();
  /// The mesh of one file, index from 0.
  vtkPolyData* GetMesh(int index);
  /// The name of one mesh, that of its block.
  std::string GetName(int index);

  /**
   * Make what was read the input of @p occluders, labelled as OccludersBy says. A single file whose triangles carry ids
   * ("OccluderId" in its cell data) keeps them as occluders in Automatic.
   */
  void LabelOccluders(vtkLabelOccluders* occluders);

  /// Does a file's name end as one of a mesh that can be read?
  static bool IsMeshFileName(const std::string& name);
  /// The extensions of files that can be read, separated by commas.
  static std::string GetFormats();

protected:
  vtkMeshFiles();
  ~vtkMeshFiles() override;

private:
  vtkMeshFiles(const vtkMeshFiles&) = delete;
  void operator=(const vtkMeshFiles&) = delete;

  std::string FreeName(const std::string& path) const;

  std::vector<std::string> FileNames;
  std::vector<std::string> Names;
  std::vector<vtkSmartPointer<vtkPolyData>> Meshes;
  vtkSmartPointer<vtkMultiBlockDataSet> Output;
  std::string Error;
  int OccludersBy = Automatic;
};

#endif
