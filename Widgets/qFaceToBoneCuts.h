#ifndef qFaceToBoneCuts_h
#define qFaceToBoneCuts_h

#include "qFaceToBoneRules.h"

#include <QColor>
#include <QObject>
#include <QStringList>

#include <vtkSmartPointer.h>

#include <array>
#include <map>
#include <memory>
#include <vector>

class vtkPolyData;
namespace f2b
{
struct BoundedPlane;
} // namespace f2b
struct qFaceToBoneCut;
struct qFaceToBoneCutCurve;
struct qFaceToBoneSpared;

/// Where is the bone to be cut? The osteotomies of a case as the surgeon wants them now, what they
/// should spare, and how the pieces may move; with undo. Knows no window and no step. [mm, RAS]
class qFaceToBoneCuts : public QObject
{
  Q_OBJECT

public:
  using Point = std::array<double, 3>;
  static constexpr int MostCuts = 8; ///< of a case

  /// How near a cut comes to a structure that it should spare.
  struct Clearance
  {
    QString name, words; ///< "nerve right", "1.4 mm from 'chin' of 'chin'"
    double distance = 0, margin = 0;
    bool near = false; ///< within the margin
    vtkSmartPointer<vtkPolyData> surface;
  };

  explicit qFaceToBoneCuts(QObject* parent = nullptr);
  ~qFaceToBoneCuts() override;

  /// Templates of the engine by their names, and what surgeons call them.
  static QStringList templates();
  static QString titleOf(const QString& templateName);
  /// One colour for the n-th cut and its fragment.
  static QColor colour(int cut);
  static QColor colourOfSpared(bool near);

  /// Takes a case's osteotomies and protected structures; \param unfinished  those that were being
  /// worked on, or null. Undo begins anew.
  void load(const nlohmann::json& document, const nlohmann::json& unfinished,
            const std::string& landmarksFile);
  void clear();
  /// Other landmarks: cuts that are as their templates put them go where these say.
  void setLandmarks(const std::string& file);
  /// The case has taken over the rules.
  void keepRules();
  /// What the case file says of them; drawn cuts are written to files in a folder. Throws Error
  /// where a cut has nothing to cut along.
  nlohmann::json osteotomies(const std::string& folder) const;
  nlohmann::json spared() const;
  /// Cuts lie elsewhere than those that were loaded.
  bool isMoved() const;
  /// They, or their rules, or what is to be spared, differ from what was loaded.
  bool isChanged() const;

  const std::vector<qFaceToBoneCut>& all() const;
  int count() const;
  int current() const { return m_current; }
  void setCurrent(int cut);
  QString error() const { return m_error; } ///< of the last call that returned false

  // what follows is one step of undo each
  bool addTemplate(const QString& name);
  /// A level plane through a point, as a cut of its own or of the current one.
  bool addPlane(const Point& at, bool ofCurrent);
  /// A line; \param free  a point on the piece that is to be free, of a cut of its own
  bool addCurve(const qFaceToBoneCutCurve& curve, const Point& free, bool ofCurrent);
  bool remove(int cut);
  /// \param part  planes first, then curves
  bool removePart(int cut, int part);
  bool rename(int cut, const QString& fragment);
  void setKerf(int cut, double mm);
  void setDepth(int cut, double mm);   ///< of all its curves
  void setOverrun(int cut, double mm); ///< of all its open lines on bone
  void setPlane(int cut, int plane, const f2b::BoundedPlane& placed);
  void setCurve(int cut, int curve, const qFaceToBoneCutCurve& drawn);
  void setPoint(int cut, const Point& free);
  /// The template's places again.
  bool placeAnew(int cut);
  bool addSpared(const QString& file);
  void removeSpared(int index);
  void setMargin(int index, double mm);
  bool setRule(const QString& fragment, std::size_t coordinate, const qFaceToBoneRule& rule);

  /// Between these two, changes are one step of undo: a drag.
  void beginDrag();
  void endDrag();
  bool canUndo() const;
  bool canRedo() const;
  bool undo();
  bool redo();

  qFaceToBoneRules rules(const QString& fragment) const;
  /// Rules of a fragment as the case file has them.
  nlohmann::json movementOf(const std::string& fragment) const;
  const std::vector<Clearance>& clearances() const;

signals:
  void changed();      ///< anything but rules
  void rulesChanged(); ///< what fragments may do

private:
  struct State;
  struct Structure;
  bool fail(const QString& message);
  bool has(int cut) const;
  void remember();
  void told(bool rules = false);
  qFaceToBoneCut* editable(int cut);
  bool addCut(qFaceToBoneCut cut);
  std::string freeName(const std::string& wish) const;
  std::shared_ptr<const Structure> structure(const qFaceToBoneSpared& spared) const;
  bool step(std::vector<State>& from, std::vector<State>& to);

  std::unique_ptr<State> m_now, m_loaded;
  std::vector<State> m_undo, m_redo;
  int m_current = -1;
  bool m_dragging = false, m_remembered = false;
  std::string m_landmarksFile;
  mutable std::map<std::string, std::shared_ptr<const Structure>> m_structures; ///< by file
  mutable std::vector<Clearance> m_clearances;                                  ///< of now
  mutable bool m_clearancesKnown = false;
  QString m_error;
};

#endif
