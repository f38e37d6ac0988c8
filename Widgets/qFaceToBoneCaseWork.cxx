#include "qFaceToBoneCaseDocument.h"

#include <Bridge/json_file.hpp>
#include <Bridge/vtk_surface.hpp>
#include <Case/fragment_json.hpp>
#include <Case/live_plan.hpp>
#include <Core/error.hpp>
#include <Core/geometry/cephalometry.hpp>
#include <Core/geometry/nearest_vertex.hpp>
#include <Core/sculpting/sculpting_session.hpp>

#include <QDateTime>
#include <QFileInfo>

#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace
{

constexpr double degree = 3.14159265358979323846 / 180;
constexpr const char* unreachedArray = "unreached_mm";

qFaceToBoneCase::Movement movementOf(const QString& fragment, const f2b::RigidMotion& motion)
{
  const f2b::EulerAngles a = f2b::euler_angles(motion.rotation);
  return {fragment,
          {motion.translation.x(), motion.translation.y(), motion.translation.z()},
          {a.pitch / degree, a.roll / degree, a.yaw / degree}};
}

f2b::RigidMotion motionOf(const qFaceToBoneCase::Movement& m, const f2b::Vec3& about, double share)
{
  f2b::RigidMotion motion;
  motion.reference_point = about;
  for (int k = 0; k < 3; ++k)
    motion.translation[k] = share * m.translation[static_cast<std::size_t>(k)];
  motion.rotation =
      f2b::rotation_from({share * degree * m.rotation[0], share * degree * m.rotation[1],
                          share * degree * m.rotation[2]});
  return motion;
}

/// Reads a displacement of the reference skin, or of a mesh with its vertices.
std::vector<f2b::Vec3> displacementIn(const std::string& path,
                                      const std::vector<f2b::Vec3>& reference)
{
  std::vector<f2b::Vec3> points = f2b::points_of(f2b::read_surface(path));
  if (points.size() != reference.size())
    throw f2b::Error(path,
                     "it has " + std::to_string(points.size()) + " vertices, the reference skin " +
                         std::to_string(reference.size()),
                     "edit the exported skin without adding, removing or merging vertices");
  for (std::size_t v = 0; v < points.size(); ++v)
    points[v] -= reference[v];
  return points;
}

} // namespace

/// The face that is worked on: what was left unfinished, else the target, else the face before.
void qFaceToBoneCase::loadSculpting()
{
  vtkPolyData* skin = m_objects.find("skin")->surface;
  const f2b::TriangleMesh reference = f2b::to_triangle_mesh(skin);
  std::vector<f2b::Vec3> displacement;
  bool unfinished = false;
  const QFileInfo sculpted(QString::fromStdString(file(sculptedFileName)));
  const QFileInfo target(QString::fromStdString(file("target.vtp")));
  try
  {
    if (sculpted.exists() && (!target.exists() || sculpted.lastModified() > target.lastModified()))
    {
      displacement = displacementIn(file(sculptedFileName), reference.points);
      unfinished = true;
    }
    else if (target.exists())
      displacement = displacementIn(file("target.vtp"), reference.points);
  }
  catch (const f2b::Error& error)
  {
    m_notes << QString::fromUtf8(error.what()); // of another skin: the face before is shown
  }
  const auto kept = m_sculpting;
  m_sculpting = std::make_shared<f2b::SculptingSession>(reference, displacement);
  m_savedRevision = m_sculpting->revision();
  m_keptRevision = unfinished ? -1 : m_sculpting->revision();
  // a step that left the face alone leaves its history alone, too
  if (kept && kept->skin().rest() == m_sculpting->skin().rest() &&
      kept->skin().displacement() == m_sculpting->skin().displacement())
  {
    m_sculpting = kept;
    m_savedRevision = kept->revision();
    m_keptRevision = unfinished ? -1 : kept->revision();
  }
  auto shown = vtkSmartPointer<vtkPolyData>::New();
  shown->DeepCopy(f2b::with_points(skin, m_sculpting->skin().points()));
  showSurface("target", tr("Target face"), shown, {232, 176, 148}, 1);
  emit skinChanged();
}

bool qFaceToBoneCase::hasUnsavedChanges() const
{
  return m_sculpting && m_sculpting->revision() != m_keptRevision;
}

bool qFaceToBoneCase::saveSculpted()
{
  if (!hasUnsavedChanges() || m_sculpting->revision() == m_savedRevision)
    return true;
  if (!exportTarget(QString::fromStdString(file(sculptedFileName))))
    return false;
  m_savedRevision = m_sculpting->revision();
  return true;
}

void qFaceToBoneCase::discardSculpted()
{
  if (!hasUnsavedChanges())
    return;
  std::error_code ignored; // where it was never written
  std::filesystem::remove(file(sculptedFileName), ignored);
  m_sculpting.reset();
  loadSculpting();
  emit changed();
}

bool qFaceToBoneCase::exportTarget(const QString& path)
{
  if (!m_sculpting)
    return fail(tr("There is no face yet; find the surfaces first"));
  return attempt(
      [&]
      {
        const std::string aside = (path + ".part." + QFileInfo(path).suffix()).toStdString();
        f2b::write_surface(
            aside, f2b::with_points(m_objects.find("skin")->surface, m_sculpting->skin().points()));
        std::filesystem::rename(aside, path.toStdString());
      });
}

bool qFaceToBoneCase::importTarget(const QString& path)
{
  if (!m_sculpting)
    return fail(tr("There is no face yet; find the surfaces first"));
  return attempt(
      [&]
      {
        m_sculpting->replace(displacementIn(path.toStdString(), m_sculpting->skin().rest()),
                             "Import");
        emit skinChanged();
        sculpted(true);
      });
}

bool qFaceToBoneCase::undo()
{
  if (!m_sculpting || !m_sculpting->undo())
    return false;
  emit skinChanged();
  sculpted(true);
  return true;
}

bool qFaceToBoneCase::redo()
{
  if (!m_sculpting || !m_sculpting->redo())
    return false;
  emit skinChanged();
  sculpted(true);
  return true;
}

QStringList qFaceToBoneCase::faceLandmarks() const
{
  constexpr double near = 4; // of the patient's own skin [mm]
  QStringList names;
  if (m_sculpting)
    for (const auto& [name, p] : m_document->landmarks)
    {
      const auto& known = f2b::landmark_definitions();
      if (std::any_of(known.begin(), known.end(),
                      [&, landmark = name](const f2b::LandmarkDefinition& d)
                      { return d.name == landmark && !d.soft_tissue; }))
        continue; // of the bone, however near
      const auto& rest = m_sculpting->skin().rest();
      if (std::any_of(rest.begin(), rest.end(),
                      [&, p = p](const f2b::Vec3& v) { return (v - p).norm() < near; }))
        names << QString::fromStdString(name);
    }
  return names;
}

bool qFaceToBoneCase::moveLandmark(const QString& name, const std::array<double, 3>& by,
                                   double radiusMm)
{
  const auto found = m_document->landmarks.find(name.toStdString());
  if (!m_sculpting || found == m_document->landmarks.end())
    return fail(tr("There is no landmark %1 on this face; choose one of the list").arg(name));
  return attempt(
      [&]
      {
        // the landmark rides on the face as it is now
        const f2b::SculptedSkin& skin = m_sculpting->skin();
        const f2b::Vec3 now = skin.points()[f2b::nearest_vertex(skin.rest(), found->second)];
        m_sculpting->begin_warp({now}, radiusMm, name.toStdString());
        m_sculpting->drag_warp({now + f2b::Vec3(by[0], by[1], by[2])});
        m_sculpting->end_stroke();
        sculpted(true);
      });
}

void qFaceToBoneCase::loadPlan()
{
  m_notes.clear();
  if (!has("plan.json"))
  {
    m_objects.remove("predicted");
    emit planChanged();
    return;
  }
  const nlohmann::json plan = f2b::read_json(file("plan.json"));
  f2b::FollowedPlan shown;
  for (const auto& fragment : plan.at("methods").at("rigid-fit").at("fragments"))
    shown.motions.push_back(f2b::motion_from(fragment));
  const auto predicted = f2b::read_surface(file("predicted_rigid-fit.vtp"));
  shown.skin_displacement = f2b::point_vectors(predicted, "displacement");
  shown.unreached_mm = f2b::point_scalars(predicted, "unreachable_mm");
  shown.solved = true;
  for (const auto& warning : plan.at("warnings"))
    m_notes << QString::fromStdString(warning.get<std::string>());
  showPlan(std::move(shown));
}

void qFaceToBoneCase::prepareLive()
{
  m_prepareAgain = m_background.isRunning();
  if (m_prepareAgain)
    return m_background.cancel();
  const auto made = std::make_shared<std::shared_ptr<f2b::LivePlan>>();
  const int generation = m_generation;
  const std::string folder = m_folder.toStdString();
  m_background.start(
      tr("Preparing the live preview"),
      [made, folder, source = m_document->source, document = documentFor(Plan),
       inUse = m_folderInUse, seen = m_isSeen](const f2b::Progress& progress)
      {
        constexpr int most = 500; // of a window that is minimised nothing is drawn
        for (int k = 0; !*seen && k < most; ++k)
        {
          progress("reading the mesh", 0);
          std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        *seen = true;
        {
          const std::lock_guard<std::mutex> alone(*inUse);
          progress("reading the mesh", 0);
          f2b::CaseSession session = f2b::CaseSession::open(folder);
          session.change_settings(document, source); // rules may be newer than the folder's
          *made = std::make_shared<f2b::LivePlan>(session);
        }
        (*made)->prepare(progress);
      },
      [this, made, generation]
      {
        if (generation != m_generation)
          return;
        m_live = *made;
        if (!m_plan)
          sculpted(true);
        emit planChanged();
      });
}

void qFaceToBoneCase::setFollowsSculpting(bool follows)
{
  m_following = follows;
  if (follows)
    sculpted(true);
}

void qFaceToBoneCase::sculpted(bool settled)
{
  emit skinChanged();
  if (settled)
    emit changed();
  if (!m_live || !m_following)
    return;
  const auto previewed = [this]
  { showFollowed(m_live->preview(m_sculpting->skin().displacement())); };
  if (!attempt(previewed))
  {
    m_notes = QStringList(m_error);
    emit planChanged();
    return;
  }
  if (settled)
    solveInBackground();
}

/// The full fit takes the preview's place when it ends; a newer face cancels it.
void qFaceToBoneCase::solveInBackground()
{
  m_solveAgain = m_background.isRunning();
  if (m_solveAgain)
    return m_background.cancel();
  if (!m_live)
    return;
  const auto result = std::make_shared<f2b::FollowedPlan>();
  const auto live = m_live;
  const auto wanted = m_sculpting->skin().displacement();
  const long revision = m_sculpting->revision();
  const int generation = m_generation;
  m_background.start(
      tr("Solving"),
      [result, live, wanted](const f2b::Progress& progress)
      { *result = live->solve(wanted, progress); },
      [this, result, revision, generation]
      {
        if (generation == m_generation && m_sculpting->revision() == revision)
          showFollowed(std::move(*result));
      });
}

/// In place of the plan that the folder holds, and of what was said of that.
void qFaceToBoneCase::showFollowed(f2b::FollowedPlan plan)
{
  m_notes.clear();
  for (const std::string& note : plan.notes)
    m_notes << QString::fromStdString(note);
  showPlan(std::move(plan));
}

void qFaceToBoneCase::showPlan(f2b::FollowedPlan plan)
{
  m_plan = std::make_unique<f2b::FollowedPlan>(std::move(plan));
  std::vector<f2b::Vec3> points = m_sculpting->skin().rest();
  for (std::size_t v = 0; v < points.size(); ++v)
    points[v] += m_plan->skin_displacement[v];
  const auto surface = f2b::with_points(m_objects.find("skin")->surface, points);
  f2b::add_point_array(surface, unreachedArray, m_plan->unreached_mm);
  showSurface("predicted", tr("Predicted face"), surface, {120, 170, 205}, 1, false);
  showFragments();
  emit planChanged();
}

void qFaceToBoneCase::showFragments()
{
  if (!m_plan)
    return;
  const std::vector<Movement> all = movements();
  for (std::size_t f = 0; f < all.size(); ++f)
  {
    const f2b::Mat4 m = motionOf(all[f], m_plan->motions[f].reference_point, m_shownShare).matrix();
    std::array<double, 16> rows{};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        rows[static_cast<std::size_t>(4 * i + j)] = m(i, j);
    m_objects.setMatrix("fragment/" + all[f].fragment, rows);
  }
}

std::vector<qFaceToBoneCase::Movement> qFaceToBoneCase::movements() const
{
  std::vector<Movement> all;
  for (std::size_t f = 0; m_plan && f < m_plan->motions.size() && f < m_fragments.size(); ++f)
    all.push_back(movementOf(m_fragments[f], m_plan->motions[f]));
  return all;
}

QString qFaceToBoneCase::planText() const
{
  if (!m_plan)
    return m_live ? tr("Sculpt the face: the bones follow.")
                  : tr("Cut the bone: then bones can follow the face.");
  double sum = 0;
  int count = 0;
  for (const double left : m_plan->unreached_mm)
    if (std::isfinite(left))
    {
      sum += left;
      ++count;
    }
  const QString left =
      count > 0 ? tr("%1 mm of the target are left on average").arg(sum / count, 0, 'f', 1)
                : tr("no target is set");
  if (m_plan->solved)
    return tr("Solved in full: %1.").arg(left);
  return tr("Preview to first order, itself %1 mm off: %2.")
      .arg(m_plan->doubt_mm, 0, 'f', 1)
      .arg(left);
}

std::array<double, 3> qFaceToBoneCase::referencePoint(const QString& fragment) const
{
  for (std::size_t f = 0; m_plan && f < m_fragments.size() && f < m_plan->motions.size(); ++f)
    if (m_fragments[f] == fragment)
    {
      const f2b::Vec3& p = m_plan->motions[f].reference_point;
      return {p.x(), p.y(), p.z()};
    }
  return {};
}

void qFaceToBoneCase::setMovementShown(double share)
{
  m_shownShare = share;
  showFragments();
}

void qFaceToBoneCase::setMovement(const Movement& wished)
{
  if (!m_plan)
    return;
  const Movement movement = allowed(wished);
  for (std::size_t f = 0; f < m_fragments.size() && f < m_plan->motions.size(); ++f)
    if (m_fragments[f] == movement.fragment)
      m_plan->motions[f] = motionOf(movement, m_plan->motions[f].reference_point, 1);
  m_following = false; // the hand leads now, not the brush
  showFragments();
  predictInBackground();
  emit planChanged();
}

qFaceToBoneCase::Movement qFaceToBoneCase::allowed(Movement movement) const
{
  constexpr double most[] = {40, 45}; // mm, degrees
  const qFaceToBoneRules rules = m_cuts.rules(movement.fragment);
  if (!rules.restraint.isEmpty()) // only a plan moves it
    for (const Movement& now : movements())
      if (now.fragment == movement.fragment)
        return now;
  for (std::size_t k = 0; k < 3; ++k)
  {
    movement.translation[k] = rules.within(k, movement.translation[k], most[0]);
    movement.rotation[k] = rules.within(k + 3, movement.rotation[k], most[1]);
  }
  return movement;
}

/// What is shown obeys new rules at once; what is planned live, when it has been linearised anew.
void qFaceToBoneCase::obeyRules()
{
  if (m_live)
    prepareLive();
  if (!m_plan)
    return;
  for (const Movement& now : movements())
  {
    const Movement obedient = allowed(now);
    if (obedient.translation != now.translation || obedient.rotation != now.rotation)
      setMovement(obedient);
  }
  emit planChanged();
}

void qFaceToBoneCase::predictInBackground()
{
  if (!m_live || m_background.isRunning())
    return;
  const auto result = std::make_shared<f2b::FollowedPlan>();
  const auto live = m_live;
  const auto wanted = m_sculpting->skin().displacement();
  const auto motions = m_plan->motions;
  const int generation = m_generation;
  m_background.start(
      tr("Predicting the face"),
      [=](const f2b::Progress& progress) { *result = live->predict(motions, wanted, progress); },
      [this, result, motions, generation]
      {
        if (generation != m_generation)
          return;
        bool same = m_plan && m_plan->motions.size() == motions.size();
        for (std::size_t f = 0; same && f < motions.size(); ++f)
          same = m_plan->motions[f].matrix() == motions[f].matrix();
        if (same)
          showFollowed(std::move(*result));
        else
          predictInBackground();
      });
}
