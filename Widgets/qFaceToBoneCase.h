#ifndef qFaceToBoneCase_h
#define qFaceToBoneCase_h

#include "qFaceToBoneCuts.h"
#include "qFaceToBoneObjects.h"
#include "qFaceToBoneTask.h"

#include <vtkSmartPointer.h>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

class qFaceToBoneRulers;
class vtkImageData;
namespace f2b
{
struct CtPreview;
class LivePlan;
class SculptingSession;
struct FollowedPlan;
struct SymmetryPlane;
} // namespace f2b

/// Where does the surgeon's work stand, and what comes next?
///
/// One case: its folder, the surfaces shown from it, the face that is being sculpted, and the steps
/// that have been done. Steps run in the background, one at a time, on the engine of `Logic/Case`;
/// their results are read back when they end. Everything here belongs to the GUI's thread.
class qFaceToBoneCase : public QObject
{
  Q_OBJECT

public:
  enum Step
  {
    Ct,
    Surfaces,
    Cuts,
    Target,
    Plan,
    Report,
  };
  static constexpr int StepCount = 6;

  /// How a step stands, for a list of steps.
  struct StepState
  {
    bool done = false;
    bool possible = false; ///< all that it needs is there
    QString text;          ///< what is done, or what is missing
    QString action;        ///< what a button would do; empty: nothing
  };

  /// The movement of a fragment as people write it.
  struct Movement
  {
    QString fragment;
    std::array<double, 3> translation{}; ///< right, anterior, superior [mm]
    std::array<double, 3> rotation{};    ///< pitch, roll, yaw [degrees]
  };

  /// A measure of the cephalometric analysis.
  struct Measure
  {
    QString name, unit, definition;
    double before = 0, planned = 0; ///< the same without a plan
  };

  /// A point that templates and measures know by name.
  struct Landmark
  {
    QString name, meaning;
    bool placed = false;
    bool needed = false;        ///< by the template that the cut uses
    std::array<double, 3> at{}; ///< where it is placed [mm, RAS]
  };

  explicit qFaceToBoneCase(QObject* parent = nullptr);
  ~qFaceToBoneCase() override;

  qFaceToBoneObjects* objects() { return &m_objects; }
  qFaceToBoneRulers* rulers() { return m_rulers; }
  qFaceToBoneTask* task() { return &m_task; }             ///< of the steps
  qFaceToBoneTask* background() { return &m_background; } ///< of live preview and full solve

  bool isOpen() const { return !m_folder.isEmpty(); }
  QString folder() const { return m_folder; }
  QString name() const;
  QString error() const { return m_error; } ///< of the last call that returned false

  /// Opens a case folder, its case.json, a case file to be worked on in a folder beside it, or a CT
  /// alone (file or DICOM folder), which is read in the background.
  bool open(const QString& path);
  /// A window draws the case and calls caseIsSeen(): until then, but for 10 s at most, the live
  /// preview of a case that has been opened is not prepared, as it takes all cores from drawing.
  void setSeenInWindow(bool seen) { m_seenInWindow = seen; }
  void caseIsSeen() { *m_isSeen = true; }
  /// Makes the virtual patient in a folder and begins its case there, in the background.
  bool openSample(const QString& folder, double meshDensity);
  void close();

  StepState state(Step step) const;
  /// Does a step, in the background. \return false if it cannot be begun (see error()).
  bool start(Step step);

  /// The CT as segmented, RAS, axes R, A, S; null before the surfaces are there.
  vtkImageData* ct() const;

  // the landmarks
  std::vector<Landmark> landmarks() const;
  /// Names that the cut's template needs and that are not placed.
  QStringList missingLandmarks() const;
  bool placeLandmark(const QString& name, const std::array<double, 3>& at);
  bool removeLandmark(const QString& name);
  /// Takes those of a file of Slicer fiducials; others stay.
  bool loadLandmarks(const QString& path);

  // the cuts
  qFaceToBoneCuts* cuts() { return &m_cuts; }
  /// The bone before any cut; null before the surfaces are there.
  vtkPolyData* bone();
  /// Keeps cuts that are being worked on in the case folder, if they have changed.
  bool saveCuts();
  double meshDensity() const;
  void setMeshDensity(double density);

  // the face that is sculpted
  std::shared_ptr<f2b::SculptingSession> sculpting() const { return m_sculpting; }
  /// To be called after strokes: the preview follows, and with `settled` the full solve.
  void sculpted(bool settled);
  bool undo();
  bool redo();
  /// Names of the case's landmarks that lie on the face.
  QStringList faceLandmarks() const;
  /// Moves the face at a landmark by so much [mm, RAS]; the face within the radius follows smoothly.
  bool moveLandmark(const QString& name, const std::array<double, 3>& by, double radiusMm);
  /// Mid-sagittal by the landmarks N, Or_R and Or_L; without them guessed from the skin's symmetry.
  f2b::SymmetryPlane symmetryPlane() const;
  bool isSymmetryGuessed() const;
  /// The face at a point is dragged by a smooth warp, as one stroke; with a plane on both sides.
  void beginDrag(const std::array<double, 3>& point, double radiusMm, bool bothSides);
  void drag(const std::array<double, 3>& by);
  void endDrag(bool keep);
  /// Where a landmark of the face is now.
  std::array<double, 3> landmarkOnFace(const QString& name) const;
  bool importTarget(const QString& path);
  bool exportTarget(const QString& path);
  /// Writes the sculpted face into the case folder, where it waits to be kept as the target.
  bool saveSculpted();
  /// Back to the face that the case folder holds as the target.
  void discardSculpted();
  /// Whether the face has been sculpted and not yet been kept as the target.
  bool hasUnsavedChanges() const;

  // the plan
  bool isLive() const { return m_live != nullptr; }
  std::vector<Movement> movements() const;
  /// Of a fragment, at rest [mm, RAS].
  std::array<double, 3> referencePoint(const QString& fragment) const;
  /// How far along the planned movement fragments are shown: 0 at rest, 1 as planned.
  void setMovementShown(double share);
  /// Moves a fragment by hand, as far as its rules allow; the face follows when the equilibrium has
  /// been solved.
  void setMovement(const Movement& wished);
  QStringList planNotes() const { return m_notes; }
  /// A sentence on where the movements shown come from and what they leave of the target.
  QString planText() const;
  /// What the landmarks allow, before and after the planned movement.
  std::vector<Measure> measures() const;
  bool followsSculpting() const { return m_following; }
  void setFollowsSculpting(bool follows);

signals:
  void changed(); ///< anything of a step, or the case itself
  void loaded();  ///< another case, or its surfaces
  void skinChanged();
  void planChanged();
  void landmarksChanged();

private:
  using Path = std::string;

  bool fail(const QString& message);
  template <class Action>
  bool attempt(Action action);
  bool openCt(const QString& path);
  void beginCt(const QString& path, const QString& folder, const f2b::CtPreview& preview);
  void showCt(const f2b::CtPreview& preview);
  void previewCt();
  void load(bool meshIsNew);
  void loadLandmarksOfCase();
  void landmarksEdited();
  void keepLandmarks();
  bool hasTargetOfItsOwn() const;
  void loadSculpting();
  void loadCuts();
  void loadPlan();
  void readCuts();
  void showSpared();
  void obeyRules();
  Movement allowed(Movement movement) const;
  void requireCuts() const;
  nlohmann::json documentFor(Step step) const;
  f2b::SymmetryPlane guessedSymmetry(vtkPolyData* skin) const;
  void findRides();
  void prepareLive();
  void showPlan(f2b::FollowedPlan plan);
  void showFollowed(f2b::FollowedPlan plan);
  void showFragments();
  void showSurface(const QString& key, const QString& name, vtkPolyData* surface,
                   const QColor& colour, double opacity = 1, bool visible = true);
  void solveInBackground();
  void predictInBackground();
  bool has(const char* file) const;
  Path file(const char* name) const;
  qFaceToBoneTask::Work work(Step step, const nlohmann::json& document) const;

  /// What a landmark moves with: a vertex of the skin, or a fragment.
  struct Ride
  {
    std::string landmark;
    int vertex, fragment; ///< -1: none
  };

  struct Document; ///< case.json, and where it was read
  std::unique_ptr<Document> m_document;
  /// Held by whoever reads or writes the case's folder in another thread.
  std::shared_ptr<std::mutex> m_folderInUse = std::make_shared<std::mutex>();
  QString m_folder, m_error;
  qFaceToBoneObjects m_objects;
  qFaceToBoneRulers* m_rulers;
  qFaceToBoneCuts m_cuts;
  vtkSmartPointer<vtkPolyData> m_bone;
  vtkSmartPointer<vtkImageData> m_ct;
  std::shared_ptr<f2b::SculptingSession> m_sculpting;
  long m_keptRevision = 0;  ///< the face as the target is; -1: none that is sculpted now
  long m_savedRevision = 0; ///< the face as last written into the folder
  std::shared_ptr<f2b::LivePlan> m_live;
  std::unique_ptr<f2b::FollowedPlan> m_plan;
  std::vector<QString> m_fragments;
  std::vector<Ride> m_rides;
  QStringList m_notes;
  struct Drag; ///< of a point of the face that is going on
  std::unique_ptr<Drag> m_drag;
  bool m_following = true, m_solveAgain = false, m_prepareAgain = false;
  bool m_seenInWindow = false;
  /// Of the case that is opened, read in the background too.
  std::shared_ptr<std::atomic<bool>> m_isSeen = std::make_shared<std::atomic<bool>>(true);
  int m_generation = 0; ///< of what is loaded: background results of an older one are dropped
  double m_shownShare = 1;
  qFaceToBoneTask m_task, m_background; // last: they end before what they use
};

#endif
