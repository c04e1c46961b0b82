// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scInputPorts.h
 * @brief The setters of a named input port, defined: SetMeshConnection and SetMeshData for the port of a mesh.
 *
 * Each class declares what its header documents; these give the bodies, which are the same everywhere.
 */
#ifndef scInputPorts_h
#define scInputPorts_h

/// @code scDefineInputPort(vtkConeSetProbe, Mesh, meshPort); @endcode defines SetMeshConnection and SetMeshData.
#define scDefineInputPort(Class, Name, port)                                                                           \
  void Class::Set##Name##Connection(vtkAlgorithmOutput* output)                                                        \
  {                                                                                                                    \
    this->SetInputConnection(port, output);                                                                            \
  }                                                                                                                    \
  void Class::Set##Name##Data(vtkDataObject* data)                                                                     \
  {                                                                                                                    \
    this->SetInputData(port, data);                                                                                    \
  }

/// A port of lights takes any number of connections: five methods.
#define scDefineLightPort(Class, port)                                                                                 \
  scDefineInputPort(Class, Light, port) void Class::AddLightConnection(vtkAlgorithmOutput* light)                      \
  {                                                                                                                    \
    this->AddInputConnection(port, light);                                                                             \
  }                                                                                                                    \
  void Class::AddLightData(vtkDataObject* light)                                                                       \
  {                                                                                                                    \
    this->AddInputDataInternal(port, light);                                                                           \
  }                                                                                                                    \
  void Class::RemoveAllLights()                                                                                        \
  {                                                                                                                    \
    this->RemoveAllInputConnections(port);                                                                             \
  }

#endif
