#include "qSlicerFaceToBoneModule.h"

#include "qSlicerFaceToBoneModuleWidget.h"

#include <vtkSlicerFaceToBoneLogic.h>

#include <QIcon>

qSlicerFaceToBoneModule::qSlicerFaceToBoneModule(QObject* parent) : Superclass(parent) {}

qSlicerFaceToBoneModule::~qSlicerFaceToBoneModule() = default;

QString qSlicerFaceToBoneModule::helpText() const
{
  return tr("Plans cranio-maxillofacial surgery from the face backwards: say how the face should "
            "look and where the bone is cut; the module computes how each bone fragment must move, "
            "predicts the face that this movement gives, and says what cannot be reached with "
            "these cuts.<br><br>"
            "Choose a CT, landmarks and a folder for the case, then work down the numbered steps. "
            "Each step writes standard files into the folder, with a scene <i>case.mrml</i> that "
            "shows them.<br><br>"
            "<b>Research software, not a medical device.</b> Do not base treatment on it.");
}

QString qSlicerFaceToBoneModule::acknowledgementText() const
{
  return tr(
      "The method starts from Wang and Yang, <i>Cranio-maxillofacial surgery simulation based "
      "on pre-specified target face configurations</i>. Built with VTK, ITK, CGAL, Eigen and "
      "SuiteSparse.");
}

QStringList qSlicerFaceToBoneModule::contributors() const
{
  return {QStringLiteral("The FaceToBone maintainers")};
}

QIcon qSlicerFaceToBoneModule::icon() const
{
  return QIcon(QStringLiteral(":/Icons/FaceToBone.png"));
}

QStringList qSlicerFaceToBoneModule::categories() const
{
  return {QStringLiteral("Surgery planning")};
}

QStringList qSlicerFaceToBoneModule::dependencies() const
{
  return {QStringLiteral("Volumes"), QStringLiteral("Models"), QStringLiteral("Markups"),
          QStringLiteral("Transforms")};
}

QStringList qSlicerFaceToBoneModule::associatedNodeTypes() const
{
  return {QStringLiteral("vtkMRMLFaceToBonePlanNode"),
          QStringLiteral("vtkMRMLFaceToBoneOsteotomyNode"),
          QStringLiteral("vtkMRMLFaceToBoneTargetNode")};
}

qSlicerAbstractModuleRepresentation* qSlicerFaceToBoneModule::createWidgetRepresentation()
{
  return new qSlicerFaceToBoneModuleWidget;
}

vtkMRMLAbstractLogic* qSlicerFaceToBoneModule::createLogic()
{
  return vtkSlicerFaceToBoneLogic::New();
}
