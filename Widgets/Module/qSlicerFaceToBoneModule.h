#ifndef __qSlicerFaceToBoneModule_h
#define __qSlicerFaceToBoneModule_h

#include "qSlicerFaceToBoneModuleExport.h"

#include <qSlicerLoadableModule.h>

/// The module as 3D Slicer lists and loads it.
class Q_SLICER_QTMODULES_FACETOBONE_EXPORT qSlicerFaceToBoneModule : public qSlicerLoadableModule
{
  Q_OBJECT
  Q_PLUGIN_METADATA(IID "org.slicer.modules.loadable.qSlicerLoadableModule/1.0");
  Q_INTERFACES(qSlicerLoadableModule);

public:
  typedef qSlicerLoadableModule Superclass;
  explicit qSlicerFaceToBoneModule(QObject* parent = nullptr);
  ~qSlicerFaceToBoneModule() override;

  qSlicerGetTitleMacro(QTMODULE_TITLE);
  QString helpText() const override;
  QString acknowledgementText() const override;
  QStringList contributors() const override;
  QIcon icon() const override;
  QStringList categories() const override;
  QStringList dependencies() const override;
  QStringList associatedNodeTypes() const override;

protected:
  qSlicerAbstractModuleRepresentation* createWidgetRepresentation() override;
  vtkMRMLAbstractLogic* createLogic() override;

private:
  Q_DISABLE_COPY(qSlicerFaceToBoneModule);
};

#endif
