#ifndef qFaceToBoneMainWindow_h
#define qFaceToBoneMainWindow_h

#include <QMainWindow>

#include <vtkSmartPointer.h>

class QLabel;
class QMenu;
class QProgressBar;
class QPushButton;
class QSlider;
class QStackedWidget;
class QTimer;
class qFaceToBoneBoneTools;
class qFaceToBoneCase;
class qFaceToBoneCutTools;
class qFaceToBoneCutsPanel;
class qFaceToBoneLandmarksPanel;
class qFaceToBoneMeasuresPanel;
class qFaceToBonePointTools;
class qFaceToBonePlanPanel;
class qFaceToBoneSculptPanel;
class qFaceToBoneSliceView;
class qFaceToBoneStepsPanel;
class qFaceToBoneThreeDView;
class vtkFaceToBoneSculptWidget;
class vtkPolyData;

/// The surgeon's workplace: steps on the left, the face and its bones in the middle, slices on the
/// right.
class qFaceToBoneMainWindow : public QMainWindow
{
  Q_OBJECT

public:
  explicit qFaceToBoneMainWindow(QWidget* parent = nullptr);
  ~qFaceToBoneMainWindow() override;

  bool open(const QString& path);
  void openSample();

  qFaceToBoneCase* work() const { return m_case; }
  qFaceToBoneStepsPanel* steps() const { return m_steps; }
  qFaceToBoneBoneTools* boneTools() const { return m_boneTools; }
  qFaceToBoneCutTools* cutTools() const { return m_cutTools; }
  qFaceToBonePointTools* pointTools() const { return m_pointTools; }
  qFaceToBoneLandmarksPanel* landmarksPanel() const { return m_landmarksPanel; }
  qFaceToBoneSculptPanel* sculptPanel() const { return m_sculptPanel; }
  qFaceToBoneThreeDView* threeDView() const { return m_view; }
  qFaceToBoneSliceView* sliceView(int k) const { return m_slices[k]; }
  vtkFaceToBoneSculptWidget* sculptTool() const;

protected:
  void closeEvent(QCloseEvent* event) override;

private:
  void makeMenus();
  QWidget* makeLeft();
  QWidget* makeCentre();
  QWidget* makeViewBar();
  QWidget* makeWelcome();
  void makeStatusBar();
  void connectCase();
  void connectTool();
  void connectBoneTools();
  bool saveAll();
  void undo();
  void redo();
  void connectPointTools();
  QWidget* makeSurfacesPage();
  void openFolder();
  bool mayLeave();
  void loadedAnother();
  void strokeMoved();
  void strokeEnded();
  void brushTurned();
  void showSkin();
  void stepChosen(int step);
  void colourTarget(int choice);
  void say(const QString& text);
  void complain(const QString& text);
  void updateRecent();
  void rememberRecent(const QString& path);
  void preferences();
  void about();
  QString sampleFolder() const;

  qFaceToBoneCase* m_case;
  qFaceToBoneStepsPanel* m_steps = nullptr;
  qFaceToBoneCutsPanel* m_cutsPanel = nullptr;
  qFaceToBonePlanPanel* m_planPanel = nullptr;
  qFaceToBoneSculptPanel* m_sculptPanel = nullptr;
  qFaceToBoneLandmarksPanel* m_landmarksPanel = nullptr;
  qFaceToBoneMeasuresPanel* m_measuresPanel = nullptr;
  qFaceToBoneBoneTools* m_boneTools = nullptr;
  qFaceToBoneCutTools* m_cutTools = nullptr;
  qFaceToBonePointTools* m_pointTools = nullptr;
  bool m_byHand = false;
  QStackedWidget *m_pages = nullptr, *m_centre = nullptr;
  qFaceToBoneThreeDView* m_view = nullptr;
  qFaceToBoneSliceView* m_slices[3]{};
  vtkSmartPointer<vtkFaceToBoneSculptWidget> m_tool;
  vtkSmartPointer<vtkPolyData> m_shownTarget; ///< that the brush writes to
  QProgressBar* m_progress = nullptr;
  QPushButton* m_cancel = nullptr;
  QLabel* m_message = nullptr;
  QMenu* m_recent = nullptr;
  QTimer* m_autosave = nullptr;
};

#endif
