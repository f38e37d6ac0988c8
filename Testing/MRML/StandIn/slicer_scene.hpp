#pragma once

#include <string>

namespace f2b::test
{

/// A scene in the form in which Slicer 5.2 writes it: nodes whose classes are known here with
/// attributes that are not, and nodes that are not known at all. Names files that are not there.
inline const std::string slicer_scene = R"xml(<?xml version="1.0" encoding="UTF-8"?>
<MRML version="Slicer 5.2.2 31382" userTags="">
 <Crosshair
  id="vtkMRMLCrosshairNodedefault" name="Crosshair" hideFromEditors="true" selectable="true" selected="false" singletonTag="default" crosshairMode="NoCrosshair" navigation="false" crosshairBehavior="JumpSlice" crosshairThickness="Fine" crosshairRAS="-0.5 4.25 12" ></Crosshair>
 <Selection
  id="vtkMRMLSelectionNodeSingleton" name="Selection" hideFromEditors="true" selectable="true" selected="false" singletonTag="Singleton" references="unit/area:vtkMRMLUnitNodeApplicationArea;unit/length:vtkMRMLUnitNodeApplicationLength;ActiveVolume:vtkMRMLScalarVolumeNode1;" ></Selection>
 <View
  id="vtkMRMLViewNode1" name="View1" hideFromEditors="false" selectable="true" selected="false" singletonTag="1" attributes="MappedInLayout:1" layoutLabel="1" layoutName="1" active="false" visibility="true" backgroundColor="0.756863 0.764706 0.909804" backgroundColor2="0.454902 0.470588 0.745098" fieldOfView="200" letterSize="0.05" boxVisible="true" fiducialsVisible="true" orientationMarkerType="none" rulerType="none" axisLabels="L;R;P;A;I;S" fpsVisible="false" useDepthPeeling="true" ></View>
 <Slice
  id="vtkMRMLSliceNodeRed" name="Red" hideFromEditors="false" selectable="true" selected="false" singletonTag="Red" layoutLabel="R" layoutName="Red" orientation="Axial" fieldOfView="306.25 235.78 1" dimensions="400 308 1" sliceToRAS="-1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1" orientationMatrixAxial="-1 0 0 0 1 0 0 0 1" ></Slice>
 <Layout
  id="vtkMRMLLayoutNodevtkMRMLLayoutNode" name="Layout" hideFromEditors="true" selectable="true" selected="false" singletonTag="vtkMRMLLayoutNode" currentViewArrangement="3" guiPanelVisibility="1" layout="&lt;layout type=&quot;vertical&quot;&gt;&lt;/layout&gt;" ></Layout>
 <SubjectHierarchy
  id="vtkMRMLSubjectHierarchyNode1" name="SubjectHierarchy" hideFromEditors="false" selectable="true" selected="false" attributes="SubjectHierarchyVersion:2" >
   <SubjectHierarchyItem id="3" dataNode="" parent="0" type="" expanded="true" attributes="Level^Scene|">
     <SubjectHierarchyItem id="8" dataNode="vtkMRMLScalarVolumeNode1" parent="3" type="Volumes" expanded="true" attributes="Level^Patient &amp; study|"></SubjectHierarchyItem>
     <SubjectHierarchyItem id="9" dataNode="vtkMRMLModelNode4" parent="3" type="Models" expanded="false"></SubjectHierarchyItem>
   </SubjectHierarchyItem>
 </SubjectHierarchy>
 <ModelDisplay
  id="vtkMRMLModelDisplayNode4" name="ModelDisplay" hideFromEditors="true" selectable="true" selected="false" color="0.694118 0.478431 0.396078" edgeColor="0 0 0" selectedColor="1 0 0" selectedAmbient="0.4" ambient="0" diffuse="1" selectedSpecular="0.5" specular="0" power="1" metallic="0" roughness="0.5" opacity="0.85" sliceIntersectionOpacity="1" pointSize="1" lineWidth="1" representation="2" lighting="true" interpolation="1" shading="true" visibility="true" visibility2D="true" visibility3D="true" edgeVisibility="false" clipping="false" sliceIntersectionThickness="3" frontfaceCulling="false" backfaceCulling="false" scalarVisibility="true" vectorVisibility="false" tensorVisibility="false" interpolateTexture="false" scalarRangeFlag="UseManual" scalarRange="-5 5" colorNodeID="vtkMRMLColorTableNodeFileDivergingBlueRed.txt" activeScalarName="signed distance" activeAttributeLocation="point" viewNodeRef="" folderDisplayOverrideAllowed="true" coatStrength="0.25" sliceDisplayMode="intersection" thresholdEnabled="false" thresholdRange="0 -1" backfaceColorHSVOffset="-0.05 -0.1 0" ></ModelDisplay>
 <Model
  id="vtkMRMLModelNode4" name="Skin &quot;soft&quot; &amp; lips" hideFromEditors="false" selectable="true" selected="false" attributes="Plan.Note:50%25 of it%3B then more;Seen:yes" references="display:vtkMRMLModelDisplayNode4;storage:vtkMRMLModelStorageNode1;transform:vtkMRMLLinearTransformNode4;" userTags="" ></Model>
 <ModelStorage
  id="vtkMRMLModelStorageNode1" name="ModelStorage" hideFromEditors="true" selectable="true" selected="false" fileName="Data/Skin%20%27soft%27.vtk" useCompression="1" defaultWriteFileExtension="vtk" readState="0" writeState="0" coordinateSystem="LPS" checksum="abc123" ></ModelStorage>
 <LinearTransform
  id="vtkMRMLLinearTransformNode4" name="Move" hideFromEditors="false" selectable="true" selected="false" references="storage:vtkMRMLTransformStorageNode1;" userTags="" center="1 2 3" matrixTransformToParent="1 0 0 12.3457 0 1 0 -2 0 0 1 0.5 0 0 0 1" ></LinearTransform>
 <TransformStorage
  id="vtkMRMLTransformStorageNode1" name="TransformStorage" hideFromEditors="true" selectable="true" selected="false" fileName="Data/Move.h5" useCompression="1" defaultWriteFileExtension="h5" readState="0" writeState="0" preferITKv3CompatibleTransforms="false" ></TransformStorage>
 <VolumeDisplay
  id="vtkMRMLScalarVolumeDisplayNode1" name="VolumeDisplay" hideFromEditors="true" selectable="true" selected="false" color="0.9 0.9 0.3" colorNodeID="vtkMRMLColorTableNodeGrey" window="350" level="40.5" upperThreshold="3071" lowerThreshold="-1024" interpolate="1" windowLevelLocked="false" autoWindowLevel="0" applyThreshold="0" autoThreshold="0" windowLevelPreset0="2000|300" invertDisplayScalarRange="false" ></VolumeDisplay>
 <Volume
  id="vtkMRMLScalarVolumeNode1" name="CT" hideFromEditors="false" selectable="true" selected="false" attributes="DICOM.instanceUIDs:1.2.3 1.2.4" references="display:vtkMRMLScalarVolumeDisplayNode1;storage:vtkMRMLVolumeArchetypeStorageNode1;" userTags="" spacing="0.488281 0.488281 1.25" origin="125 124.5 -80" voxelVectorType="undefined" ijkToRASDirections="-1   0   0 0   -1   0 0 0 1 " measurementFrame="1 0 0 0 1 0 0 0 1" voxelValueUnits="(%22hnsf%22, %22UCUM%22, %22Hounsfield unit%22)" ></Volume>
 <VolumeArchetypeStorage
  id="vtkMRMLVolumeArchetypeStorageNode1" name="VolumeArchetypeStorage" hideFromEditors="true" selectable="true" selected="false" fileName="Data/CT.nrrd" useCompression="1" compressionParameter="gzip_fastest" defaultWriteFileExtension="nrrd" readState="0" writeState="4" centerImage="0" UseOrientationFromFile="1" ></VolumeArchetypeStorage>
 <MarkupsFiducialDisplay
  id="vtkMRMLMarkupsFiducialDisplayNode1" name="" hideFromEditors="true" selectable="true" selected="false" color="0.4 1 1" selectedColor="1 0.5 0.5" opacity="1" visibility="true" propertiesLabelVisibility="false" pointLabelsVisibility="true" textScale="3" glyphScale="3" glyphSize="5" useGlyphScale="true" glyphType="Sphere3D" snapMode="toVisibleSurface" sliceProjection="false" sliceProjectionOpacity="0.6" curveLineSizeMode="UseLineThickness" lineThickness="0.2" lineDiameter="1" handlesInteractive="false" translationHandleVisibility="true" fillVisibility="true" outlineVisibility="true" fillOpacity="0.5" outlineOpacity="1" occludedVisibility="false" occludedOpacity="0.3" textProperty="font-family:Arial;font-size:5px;font-style:normal;" activeColor="0.4 1 0" interactionHandleScale="3" ></MarkupsFiducialDisplay>
 <MarkupsFiducial
  id="vtkMRMLMarkupsFiducialNode1" name="Landmarks" hideFromEditors="false" selectable="true" selected="false" references="display:vtkMRMLMarkupsFiducialDisplayNode1;storage:vtkMRMLMarkupsJsonStorageNode1;" userTags="" locked="false" controlPointLabelFormat="%N-%d" interactionHandleToWorldMatrix="1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1" maximumNumberOfControlPoints="-1" requiredNumberOfControlPoints="0" textList0="length: 3mm" ></MarkupsFiducial>
 <MarkupsJsonStorage
  id="vtkMRMLMarkupsJsonStorageNode1" name="MarkupsJsonStorage" hideFromEditors="true" selectable="true" selected="false" fileName="Data/Landmarks.mrk.json" useCompression="1" defaultWriteFileExtension="mrk.json" readState="0" writeState="0" coordinateSystem="LPS" ></MarkupsJsonStorage>
 <Segmentation
  id="vtkMRMLSegmentationNode1" name="Segmentation" hideFromEditors="false" selectable="true" selected="false" references="display:vtkMRMLSegmentationDisplayNode1;referenceImageGeometryRef:vtkMRMLScalarVolumeNode1;storage:vtkMRMLSegmentationStorageNode1;" segmentListFilterEnabled="false" segmentListFilterOptions="" ></Segmentation>
 <SegmentationStorage
  id="vtkMRMLSegmentationStorageNode1" name="SegmentationStorage" hideFromEditors="true" selectable="true" selected="false" fileName="Data/Segmentation.seg.nrrd" fileListMember0="Data/Segmentation.seg.nrrd" useCompression="1" readState="0" writeState="0" CropToMinimumExtent="true" ></SegmentationStorage>
 <SegmentationDisplay
  id="vtkMRMLSegmentationDisplayNode1" name="SegmentationDisplay" hideFromEditors="true" selectable="true" selected="false" PreferredDisplayRepresentationName2D="Closed surface" Opacity3D="1" SegmentationDisplayProperties="Segment_1 OverrideColor:-1,-1,-1 Visible:true|" ></SegmentationDisplay>
</MRML>
)xml";

} // namespace f2b::test
