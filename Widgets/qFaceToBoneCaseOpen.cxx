#include "qFaceToBoneCaseDocument.h"
#include "qFaceToBoneRulers.h"

#include <Bridge/json_file.hpp>
#include <Case/ct_preview.hpp>
#include <Case/live_plan.hpp>
#include <Case/verbs.hpp>
#include <Core/error.hpp>
#include <Core/geometry/scalar_grid.hpp>
#include <Core/sculpting/sculpting_session.hpp>

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

using f2b::Progress;

namespace
{

/// Where a case of a CT goes: beside it, or among the user's documents where that cannot be written.
QString folderBeside(const QFileInfo& ct)
{
  QString name = ct.fileName();
  if (!ct.isDir())
    name = name.left(name.indexOf('.', 1));
  const QFileInfo parent(ct.absolutePath());
  const QDir home = parent.isWritable()
                        ? QDir(parent.filePath())
                        : QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
                              .filePath("FaceToBone");
  return home.filePath(name + "-facetobone");
}

} // namespace

/// The grid as VTK shows it.
vtkSmartPointer<vtkImageData> qFaceToBoneImageOf(const f2b::ScalarGrid& grid)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(grid.size.x(), grid.size.y(), grid.size.z());
  image->SetOrigin(grid.origin.x(), grid.origin.y(), grid.origin.z());
  image->SetSpacing(grid.spacing, grid.spacing, grid.spacing);
  vtkNew<vtkFloatArray> values;
  values->SetName("HU");
  values->SetNumberOfTuples(static_cast<vtkIdType>(grid.values.size()));
  std::copy(grid.values.begin(), grid.values.end(), values->GetPointer(0));
  image->GetPointData()->SetScalars(values);
  return image;
}

bool qFaceToBoneCase::open(const QString& path)
{
  if (m_task.isRunning())
    return fail(tr("%1 is still going on; cancel it first").arg(m_task.title()));
  const bool isCase = QFileInfo::exists(QDir(path).filePath("case.json"));
  if (!isCase && QFileInfo::exists(path) && f2b::may_be_ct(path.toStdString()))
    return openCt(path);
  return attempt(
      [&]
      {
        const QFileInfo given(path);
        if (!given.exists())
          throw f2b::Error(path.toStdString(), "there is no such file or folder",
                           "choose a case, a case file (JSON) or a CT");
        QFileInfo settings = given;
        if (given.isDir() || given.suffix() == "mrml")
          settings = QFileInfo(
              QDir(given.isDir() ? given.filePath() : given.path()).filePath("case.json"));
        if (!settings.exists())
          throw f2b::Error(path.toStdString(), "it is no case: it holds no case.json",
                           "choose a case, a case file (JSON) or a CT");
        const bool begun = QFileInfo::exists(settings.dir().filePath("segment.json"));
        QString folder = settings.absolutePath();
        if (!begun)
          folder = settings.dir().absoluteFilePath(settings.completeBaseName() + "-facetobone");
        Document document;
        document.source = settings.absoluteFilePath().toStdString();
        const QString inside = QDir(folder).filePath("case.json");
        if (!begun && QFileInfo::exists(inside)) // goes on where it was left
          document.source = inside.toStdString();
        document.json = f2b::read_json(document.source);
        (void)f2b::parse_settings(document.json, document.source);
        document.json = f2b::with_absolute_paths(document.json, document.source);
        close();
        *m_document = std::move(document);
        m_folder = folder;
        m_rulers->load(file(rulersFileName));
        m_isSeen = std::make_shared<std::atomic<bool>>(!m_seenInWindow);
        load(true);
        if (!has("skin.vtp"))
          previewCt();
      });
}

/// A CT alone: its own case, which knows no landmarks, no cuts and no target yet.
bool qFaceToBoneCase::openCt(const QString& path)
{
  const QFileInfo given(path);
  const QString absolute = given.absoluteFilePath(), folder = folderBeside(QFileInfo(absolute));
  if (QFileInfo::exists(QDir(folder).filePath("case.json"))) // goes on where it was left
    return open(folder);
  const auto preview = std::make_shared<f2b::CtPreview>();
  const auto read =
      [preview, ct = absolute.toStdString(), inUse = m_folderInUse](const Progress& progress)
  {
    const std::lock_guard<std::mutex> alone(*inUse); // one reader at a time: it hushes the streams
    *preview = f2b::preview_ct(ct, {}, progress);
  };
  const auto show = [this, preview, absolute, folder] { beginCt(absolute, folder, *preview); };
  if (!m_task.start(tr("Reading %1").arg(given.fileName()), read, show))
    return fail(tr("%1 is still going on; cancel it first").arg(m_task.title()));
  return true;
}

void qFaceToBoneCase::beginCt(const QString& path, const QString& folder,
                              const f2b::CtPreview& preview)
{
  close();
  m_folder = folder;
  const QString landmarks = QDir(folder).filePath(placedLandmarksFileName);
  m_document->source = path.toStdString();
  m_document->json = {
      {"schema", "facetobone-case/1"},
      {"name", QFileInfo(path).fileName().toStdString()},
      {"ct", path.toStdString()},
      {"landmarks", landmarks.toStdString()},
      {"osteotomies", {{{"fragment", "maxilla"}, {"template", "le-fort-1"}}}},
      {"target", {{"from_movement", {{"maxilla", nlohmann::json::object()}}}, {"mask_mm", 1.0}}}};
  m_rulers->load(file(rulersFileName));
  readCuts();
  for (const std::string& note : preview.notes)
    m_notes << QString::fromStdString(note);
  showCt(preview);
}

void qFaceToBoneCase::showCt(const f2b::CtPreview& preview)
{
  m_ct = qFaceToBoneImageOf(preview.hu);
  showSurface(rawSkinKey, tr("CT, skin"), preview.skin, {235, 186, 161}, 0.45);
  showSurface(rawBoneKey, tr("CT, bone"), preview.bone, {236, 222, 186});
  emit loaded();
  emit changed();
}

/// A case in which nothing has been found yet shows its CT as soon as it has been read.
void qFaceToBoneCase::previewCt()
{
  const f2b::CaseSettings settings = f2b::parse_settings(m_document->json, m_document->source);
  const auto preview = std::make_shared<f2b::CtPreview>();
  const int generation = m_generation;
  m_background.start(
      tr("Reading the CT"),
      [preview, ct = settings.ct, reading = settings.reading,
       inUse = m_folderInUse](const Progress& progress)
      {
        const std::lock_guard<std::mutex> alone(*inUse);
        *preview = f2b::preview_ct(ct, reading, progress);
      },
      [this, preview, generation]
      {
        if (generation == m_generation && !has("skin.vtp"))
          showCt(*preview);
      });
}

/// Whether the case names a target, besides the one that stands for none yet.
bool qFaceToBoneCase::hasTargetOfItsOwn() const
{
  const auto target = m_document->json.find("target");
  if (target == m_document->json.end() || !target->contains("from_movement"))
    return target != m_document->json.end();
  for (const auto& movement : target->at("from_movement"))
    if (!movement.empty())
      return true;
  return false;
}

bool qFaceToBoneCase::openSample(const QString& folder, double meshDensity)
{
  const std::string patient = QDir(folder).filePath("patient").toStdString();
  const auto write = [patient](const Progress& progress)
  {
    if (!std::filesystem::exists(patient + "/case.json"))
      f2b::write_sample(patient, {}, progress);
  };
  const auto begin = [this, patient, folder, meshDensity]
  {
    close();
    m_document->source = patient + "/case.json";
    m_document->json =
        f2b::with_absolute_paths(f2b::read_json(m_document->source), m_document->source);
    m_document->json["mesh"]["density"] = meshDensity;
    m_folder = QDir(folder).filePath("case");
    if (has("case.json"))
      m_document->json = f2b::read_json(m_document->source = file("case.json"));
    m_rulers->load(file(rulersFileName));
    m_isSeen = std::make_shared<std::atomic<bool>>(!m_seenInWindow);
    load(true);
    if (!has("skin.vtp"))
      previewCt();
  };
  if (!m_task.start(tr("Making the sample case"), write, begin))
    return fail(tr("%1 is still going on; cancel it first").arg(m_task.title()));
  return true;
}
