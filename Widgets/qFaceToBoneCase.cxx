#include "qFaceToBoneCaseDocument.h"
#include "qFaceToBoneRulers.h"

#include <Bridge/grid_file.hpp>
#include <Bridge/json_file.hpp>
#include <Bridge/markups.hpp>
#include <Bridge/vtk_surface.hpp>
#include <Case/live_plan.hpp>
#include <Case/verbs.hpp>
#include <Core/error.hpp>
#include <Core/sculpting/sculpting_session.hpp>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QProcess>

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSlicerFaceToBoneLogic.h>

namespace
{

using f2b::CaseSession;
using f2b::Progress;

/// The part of a longer progress that one verb is.
Progress partOf(const Progress& whole, double begin, double end)
{
  return [whole, begin, end](std::string_view what, double fraction)
  { whole(what, begin + fraction * (end - begin)); };
}

QString thousands(vtkIdType count)
{
  return QLocale(QLocale::English).toString(static_cast<qlonglong>(count));
}

/// The command-line program: beside this one, or where the environment says.
QString commandLineProgram()
{
  const QByteArray told = qgetenv("FACETOBONE_PROGRAM");
  return told.isEmpty() ? QDir(QCoreApplication::applicationDirPath()).filePath("facetobone")
                        : QString::fromLocal8Bit(told);
}

/// In a process of its own: drawing without a screen wants a display that is not the window's.
void writeReport(const std::string& folder, const Progress& progress)
{
  QProcess program;
  program.start(commandLineProgram(), {"report", QString::fromStdString(folder), "--quiet"});
  if (!program.waitForStarted())
    throw f2b::Error(commandLineProgram().toStdString(), "it cannot be started",
                     "install facetobone beside FaceToBone");
  double share = 0;
  while (!program.waitForFinished(200) && program.state() != QProcess::NotRunning)
  {
    share += 0.01 * (1 - share);
    try
    {
      progress("drawing the report", share);
    }
    catch (...)
    {
      program.kill();
      program.waitForFinished();
      throw;
    }
  }
  if (program.exitStatus() != QProcess::NormalExit || program.exitCode() != 0)
    throw std::runtime_error(program.readAllStandardError().trimmed().toStdString());
}

} // namespace

qFaceToBoneCase::qFaceToBoneCase(QObject* parent)
    : QObject(parent), m_document(std::make_unique<Document>()),
      m_rulers(new qFaceToBoneRulers(&m_objects, this))
{
  connect(&m_task, &qFaceToBoneTask::ended, this, &qFaceToBoneCase::changed);
  connect(&m_task, &qFaceToBoneTask::started, this, &qFaceToBoneCase::changed);
  connect(&m_cuts, &qFaceToBoneCuts::changed, this, &qFaceToBoneCase::showSpared);
  connect(&m_cuts, &qFaceToBoneCuts::changed, this, &qFaceToBoneCase::changed);
  connect(&m_cuts, &qFaceToBoneCuts::rulesChanged, this, &qFaceToBoneCase::obeyRules);
  connect(&m_background, &qFaceToBoneTask::ended, this,
          [this]
          {
            if (m_prepareAgain)
              prepareLive();
            else if (m_solveAgain)
              solveInBackground();
            emit changed();
          });
}

qFaceToBoneCase::~qFaceToBoneCase() = default;

bool qFaceToBoneCase::fail(const QString& message)
{
  m_error = message;
  return false;
}

std::string qFaceToBoneCase::file(const char* name) const
{
  return QDir(m_folder).filePath(name).toStdString();
}

bool qFaceToBoneCase::has(const char* name) const
{
  return isOpen() && QFileInfo::exists(QDir(m_folder).filePath(name));
}

QString qFaceToBoneCase::name() const
{
  if (!isOpen())
    return {};
  const auto found = m_document->json.find("name");
  return found == m_document->json.end() ? QFileInfo(m_folder).fileName()
                                         : QString::fromStdString(found->get<std::string>());
}

vtkImageData* qFaceToBoneCase::ct() const
{
  return m_ct;
}

void qFaceToBoneCase::close()
{
  saveSculpted();
  saveCuts();
  m_background.cancel();
  m_solveAgain = m_prepareAgain = false;
  ++m_generation;
  m_folder.clear();
  *m_document = {};
  m_ct = nullptr;
  m_sculpting.reset();
  m_live.reset();
  m_plan.reset();
  m_fragments.clear();
  m_notes.clear();
  m_cuts.clear();
  m_bone = nullptr;
  m_rulers->load("");
  m_objects.clear();
  emit loaded();
  emit changed();
}

void qFaceToBoneCase::showSurface(const QString& key, const QString& name, vtkPolyData* surface,
                                  const QColor& colour, double opacity, bool visible)
{
  qFaceToBoneObject object;
  object.key = key;
  object.name = name;
  object.surface = surface;
  object.colour = colour;
  object.opacity = opacity;
  object.visible = visible;
  m_objects.put(object);
}

/// Reads what the folder holds.
void qFaceToBoneCase::load(bool meshIsNew)
{
  saveSculpted(); // strokes that were made while a step ran: the face is read again below
  if (meshIsNew)
  {
    ++m_generation;
    m_live.reset();
  }
  m_plan.reset();
  if (has("case.json"))
  {
    m_document->source = file("case.json");
    m_document->json =
        f2b::with_absolute_paths(f2b::read_json(m_document->source), m_document->source);
  }
  loadLandmarksOfCase();
  if (meshIsNew)
  {
    m_bone = nullptr;
    readCuts();
  }
  if (has("ct.nrrd"))
    m_ct = qFaceToBoneImageOf(f2b::read_scalar_grid(file("ct.nrrd")));
  if (has("skin.vtp"))
  {
    m_objects.remove(rawSkinKey);
    m_objects.remove(rawBoneKey);
    showSurface("skin", tr("Face before"), f2b::read_surface(file("skin.vtp")), {235, 186, 161}, 1,
                false);
    m_document->guessed.reset();
    loadSculpting();
    loadCuts();
    findRides();
    loadPlan();
    if (meshIsNew && has("mesh.vtu") && has("cut.json"))
      prepareLive();
  }
  emit loaded();
  emit changed();
}

void qFaceToBoneCase::loadCuts()
{
  m_fragments.clear();
  std::vector<QString> gone;
  for (const qFaceToBoneObject& o : m_objects.all())
    if (o.key.startsWith("fragment/"))
      gone.push_back(o.key);
  for (const QString& key : gone)
    m_objects.remove(key);
  if (!has("cut.json"))
  {
    m_objects.remove("uncut");
    return showSurface("bone", tr("Bone"), f2b::read_surface(file("bone.vtp")), {236, 222, 186});
  }
  m_objects.remove("bone");
  showSurface("uncut", tr("Bone that stays"), f2b::read_surface(file("uncut_bone.vtp")),
              {236, 222, 186});
  const nlohmann::json cut = f2b::read_json(file("cut.json"));
  for (const auto& fragment : cut.at("fragments"))
  {
    const auto fragmentName = fragment.at("name").get<std::string>();
    const QString text = QString::fromStdString(fragmentName);
    showSurface(
        "fragment/" + text, text,
        f2b::read_surface(file(("fragment_" + f2b::file_part(fragmentName) + ".vtp").c_str())),
        qFaceToBoneCuts::colour(static_cast<int>(m_fragments.size())));
    m_fragments.push_back(text);
  }
}

qFaceToBoneCase::StepState qFaceToBoneCase::state(Step step) const
{
  StepState s;
  const bool idle = !m_task.isRunning();
  const qFaceToBoneObject* skin = m_objects.find("skin");
  switch (step)
  {
  case Ct:
    s.done = isOpen();
    s.text = s.done ? QFileInfo(QString::fromStdString(m_document->json.value("ct", std::string())))
                          .fileName()
                    : tr("Open a case, or the sample");
    s.action = tr("Open...");
    s.possible = idle;
    return s;
  case Surfaces:
    s.done = has("skin.vtp");
    s.text = !s.done ? (m_ct ? tr("The CT is read; press Find") : tr("Skin and bone not yet found"))
                     : tr("Skin of %1 vertices")
                           .arg(skin ? thousands(skin->surface->GetNumberOfPoints()) : "?");
    s.possible = idle && isOpen();
    s.action = s.done ? tr("Again") : tr("Find");
    return s;
  case Cuts:
    s.done = has("cut.json") && has("mesh.json") && !m_cuts.isMoved();
    s.possible = idle && has("skin.vtp") && m_cuts.count() > 0 && missingLandmarks().isEmpty();
    s.text = s.done             ? tr("%1 fragment(s), tissue meshed").arg(m_fragments.size())
             : !has("skin.vtp") ? tr("Needs surfaces, then landmarks")
             : !missingLandmarks().isEmpty()
                 ? tr("Place landmarks first (step 2): %1").arg(missingLandmarks().join(", "))
             : m_cuts.count() == 0 ? tr("Add a cut: a template, a plane or a line")
             : has("cut.json")     ? tr("Changed since the bone was cut")
                                   : tr("%1 cut(s) ready").arg(m_cuts.count());
    s.action = s.done ? tr("Again") : tr("Cut");
    return s;
  case Target:
    s.done = has("target.json") && !hasUnsavedChanges();
    s.possible = idle && has("skin.vtp") && (hasUnsavedChanges() || hasTargetOfItsOwn());
    s.text = s.done                    ? tr("The face to be reached is set")
             : hasUnsavedChanges()     ? tr("Sculpted, not yet kept")
             : s.possible              ? tr("Sculpt it, or take the case's own")
             : idle && has("skin.vtp") ? tr("Sculpt the face, or move a landmark")
                                       : tr("Needs surfaces");
    s.action = hasUnsavedChanges() ? tr("Keep") : tr("Take");
    return s;
  case Plan:
    s.done = has("plan.json");
    s.possible = idle && has("mesh.json") && has("target.json");
    s.text = s.done              ? tr("Movements found")
             : s.possible        ? tr("Ready to find the movements")
             : !has("mesh.json") ? tr("Needs cuts")
                                 : tr("Needs a target");
    s.action = s.done ? tr("Again") : tr("Plan");
    return s;
  case Report:
    s.done = has("report.html");
    s.possible = idle && has("plan.json");
    s.text = s.done ? tr("report.html is written")
                    : (s.possible ? tr("Ready to be written") : tr("Needs a plan"));
    s.action = tr("Write");
    return s;
  }
  return s;
}

/// What runs in the other thread: knows the folder and a copy of the settings, nothing of ours.
qFaceToBoneTask::Work qFaceToBoneCase::work(Step step, const nlohmann::json& document) const
{
  const std::string folder = m_folder.toStdString(), source = m_document->source;
  const auto inUse = m_folderInUse;
  if (step == Surfaces)
    return [=](const Progress& progress)
    {
      const std::lock_guard<std::mutex> alone(*inUse);
      CaseSession session(folder, document, source, progress);
      session.folder.set_commit_hook(vtkSlicerFaceToBoneLogic::WriteCaseScene);
      f2b::segment_case(session);
    };
  if (step == Report)
    return [=](const Progress& progress)
    {
      const std::lock_guard<std::mutex> alone(*inUse);
      writeReport(folder, progress);
    };
  return [=](const Progress& progress)
  {
    const std::lock_guard<std::mutex> alone(*inUse);
    CaseSession session = CaseSession::open(folder, progress);
    session.folder.set_commit_hook(vtkSlicerFaceToBoneLogic::WriteCaseScene);
    session.change_settings(document, source);
    switch (step)
    {
    case Cuts:
      session.progress = partOf(progress, 0, 0.2);
      f2b::cut_case(session);
      session.progress = partOf(progress, 0.2, 1);
      f2b::mesh_case(session);
      break;
    case Target:
      f2b::target_case(session);
      break;
    default:
      f2b::plan_case(session);
    }
  };
}

bool qFaceToBoneCase::start(Step step)
{
  static const char* const titles[] = {
      "",         "Finding skin and bone", "Cutting and meshing", "Making the target",
      "Planning", "Writing the report"};
  if (step == Ct || !state(step).possible)
    return fail(tr("This step cannot be done yet: %1").arg(state(step).text));
  if (step == Target && hasUnsavedChanges())
  {
    if (!saveSculpted())
      return false;
    nlohmann::json& target = m_document->json["target"];
    const double mask = target.value("mask_mm", 1.0);
    target = {{"mesh", file(sculptedFileName)}, {"mask_mm", mask}};
  }
  nlohmann::json document;
  if (!attempt([&] { document = documentFor(step); }) || !saveCuts())
    return false;
  if (!hasTargetOfItsOwn()) // none yet: a movement of the first fragment by nothing stands for it
    document["target"]["from_movement"] = {
        {document.at("osteotomies").at(0).value("fragment", std::string()),
         nlohmann::json::object()}};
  if (step == Surfaces && !attempt([this] { keepLandmarks(); }))
    return false;
  if (step <= Cuts) // the mesh goes, and what is kept of it in memory
  {
    m_background.cancel();
    m_live.reset();
  }
  return m_task.start(tr(titles[step]), work(step, document),
                      [this, step]
                      {
                        if (step <= Cuts) // they are the case's own now
                          QFile::remove(QDir(m_folder).filePath(unfinishedCutsFileName));
                        if (step == Target) // which keeps the rules of now in the case
                          m_cuts.keepRules();
                        load(step <= Cuts);
                      });
}
